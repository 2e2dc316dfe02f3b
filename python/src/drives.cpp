// Single stages on NumPy arrays: connect and convert.
#include <pybind11/stl.h>

#include <optional>

#include "calls.hpp"
#include "cli/connect_stage.hpp"
#include "stage_parts.hpp"

namespace strandline::python {
namespace {

constexpr const char* pair_place = "connect";

/// Of the one pair: its place in a file means nothing here.
template <class T>
T of_pair(Outcome<T> outcome) {
    if (!outcome && outcome.error().place.starts_with("line 1")) outcome.error().place = pair_place;
    return value(std::move(outcome));
}

py::dict connect(const std::string& pair_text, const std::string& style, double extra_length, bool quick,
                 std::optional<double> step) {
    if (!(extra_length >= 0 && extra_length <= 10))
        throw Refused{{"extra_length", "is not within 0 to 10", "write a share, such as 0.1"}};
    if (step && !(*step > 0)) throw Refused{{"step", "is not above 0", "write metres, such as 0.01"}};
    const stages::Pair pair = of_pair(stages::read_pair(pair_text, 1, {}));
    const connect::Options options{.style = value(cli::style_of(style)),
                                   .limits = pair.limits,
                                   .refined = !quick,
                                   .extra_length = extra_length};
    const cli::Led led = value([&]() -> Outcome<cli::Led> {
        const py::gil_scoped_release released;
        auto made = connect::connection(pair.from, pair.through, pair.to, options);
        if (!made) return tl::unexpected(made.error());
        return cli::led_round(pair, std::move(*made));
    }());
    constexpr double share_of_radius = 0.01;
    constexpr int least = 9;
    const Curve& curve = led.connection.curve;
    const std::vector<CurvePoint> points =
        sampled(curve, step.value_or(share_of_radius * pair.limits.radius), least);
    py::dict result;
    const auto add = [&](const char* name, auto get) { result[name] = column<double>(points, get); };
    add("s", [](const CurvePoint& p) { return p.s; });
    add("x", [](const CurvePoint& p) { return p.pose.at.x; });
    add("y", [](const CurvePoint& p) { return p.pose.at.y; });
    add("heading", [](const CurvePoint& p) { return p.pose.heading; });
    add("curvature", [](const CurvePoint& p) { return p.curvature; });
    py::array_t<double> pieces({static_cast<py::ssize_t>(curve.pieces.size()), py::ssize_t{3}});
    double* out = pieces.mutable_data();
    for (const Clothoid& c : curve.pieces)
        for (const double x : {c.length, c.curvature, c.sharpness}) *out++ = x;
    result["pieces"] = pieces;
    result["length"] = length(curve);
    result["round_obstacles"] = led.round;
    result["fallback"] = led.connection.broken;
    result["failure"] = led.failure;
    return result;
}

using Stroke = std::pair<Numbers, std::vector<double>>;

stages::RakeRows rows_of(const std::vector<Stroke>& strokes, const Robot& robot) {
    stages::RakeRows rows;
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        const std::string place = "strokes[" + std::to_string(k) + "]";
        const std::vector<Point> points = points_of(strokes[k].first, 1, place);
        const std::vector<double>& pins = strokes[k].second;
        if (pins.size() != points.size())
            throw Refused{{place,
                           "has " + std::to_string(points.size()) + " points and " +
                               std::to_string(pins.size()) + " values of pins",
                           "give one value, or one a point"}};
        rows.strokes.emplace_back();
        for (std::size_t i = 0; i < points.size(); ++i)
            rows.strokes.back().push_back(
                value(stages::rake_row(points[i], pins[i], place + ", point " + std::to_string(i), robot)));
    }
    return rows;
}

py::tuple convert(const std::vector<Stroke>& strokes, const std::string& name,
                  const std::optional<std::string>& profile) {
    const Robot robot = robot_of(name, profile);
    const stages::RakeRows rows = rows_of(strokes, robot);
    const stages::Conversion conversion = [&] {
        const py::gil_scoped_release released;
        return stages::converted(rows, robot);
    }();
    using Row = stages::RobotRow;
    py::list all;
    for (const std::vector<Row>& stroke : conversion.strokes) {
        py::dict columns;
        const auto add = [&](const char* key, auto get) { columns[key] = column<double>(stroke, get); };
        add("x", [](const Row& r) { return r.pose.at.x; });
        add("y", [](const Row& r) { return r.pose.at.y; });
        add("heading", [](const Row& r) { return r.pose.heading; });
        add("curvature", [](const Row& r) { return r.curvature; });
        add("rake_x", [](const Row& r) { return r.rake.x; });
        add("rake_y", [](const Row& r) { return r.rake.y; });
        columns["pins"] = column<std::uint32_t>(stroke, [](const Row& r) { return r.pins; });
        all.append(columns);
    }
    return py::make_tuple(all, pairs_of(conversion.undrivable));
}

}  // namespace

void add_drives(py::module_& module) {
    using py::arg;
    module.def("connect", &connect, arg("pair"), arg("style"), arg("extra_length"), arg("quick"),
               arg("step"));
    module.def("convert", &convert, arg("strokes"), arg("name"), arg("profile"));
}

}  // namespace strandline::python
