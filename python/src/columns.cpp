// A plan's parts as NumPy arrays.
#include <pybind11/stl.h>

#include <variant>

#include "planned.hpp"

namespace strandline::python {
namespace {

py::dict samples(const Planned& planned) {
    const std::vector<Sample>& all = planned.plan->samples;
    py::dict columns;
    const auto add = [&](const char* name, auto get) { columns[name] = column<double>(all, get); };
    add("t", [](const Sample& s) { return s.t; });
    add("x", [](const Sample& s) { return s.pose.at.x; });
    add("y", [](const Sample& s) { return s.pose.at.y; });
    add("heading", [](const Sample& s) { return s.pose.heading; });
    add("curvature", [](const Sample& s) { return s.curvature; });
    add("v", [](const Sample& s) { return s.speed; });
    add("omega", [](const Sample& s) { return s.turn_rate; });
    add("rake_x", [](const Sample& s) { return s.rake.x; });
    add("rake_y", [](const Sample& s) { return s.rake.y; });
    columns["pins"] = column<std::uint32_t>(all, [](const Sample& s) { return s.mask; });
    columns["stroke"] = column<std::int32_t>(all, [](const Sample& s) { return s.stroke; });
    columns["motion"] =
        column<std::uint8_t>(all, [](const Sample& s) { return static_cast<std::uint8_t>(s.motion); });
    return columns;
}

py::dict element(const Element& element, double tolerance) {
    py::dict row;
    row["id"] = element.id;
    row["layer"] = element.layer;
    row["inside"] = element.inside;
    py::dict hints;
    for (const svg::Hint& hint : element.hints) hints[py::str(hint.name)] = hint.value;
    row["hints"] = hints;
    if (const auto* line = std::get_if<LineElement>(&element.what)) {
        row["kind"] = "line";
        row["closed"] = line->path.closed;
        row["pins"] = line->pins;
        row["points"] = array_of(flattened(line->path, tolerance));
    } else {
        const Region& region = std::get<RegionElement>(element.what).region;
        row["kind"] = "area";
        row["outer"] = array_of(region.outer);
        row["holes"] = arrays_of(region.holes);
    }
    return row;
}

py::list elements(const Planned& planned, double tolerance) {
    if (!(tolerance > 0)) throw Refused{{"tolerance", "is not above 0", "write metres, such as 0.002"}};
    py::list rows;
    for (const Element& e : planned.plan->drawing.elements) rows.append(element(e, tolerance));
    return rows;
}

/// As it is driven.
std::vector<Point> rake_points(const Stroke& stroke, const Entry& entry, double step) {
    std::vector<Point> points;
    for (const Curve& curve : rake_path_from(stroke, entry.node, entry.reversed))
        for (const CurvePoint& p : sampled(curve, step))
            if (points.empty() || points.back() != p.pose.at) points.push_back(p.pose.at);
    return points;
}

py::list strokes(const Planned& planned, double step) {
    if (!(step > 0)) throw Refused{{"step", "is not above 0", "write metres, such as 0.02"}};
    py::list rows;
    const Plan& plan = *planned.plan;
    for (std::size_t k = 0; k < plan.strokes.size(); ++k) {
        const Stroke& stroke = plan.strokes[k];
        py::dict row;
        row["element"] = stroke.element;
        row["closed"] = stroke.closed;
        row["fill"] = stroke.fill;
        row["pins"] = stroke.pins;
        row["entry"] = plan.order[k].node;
        row["reversed"] = plan.order[k].reversed;
        row["points"] = array_of(rake_points(stroke, plan.order[k], step));
        rows.append(row);
    }
    return rows;
}

/// (N, 4): x, y, heading, curvature.
py::array_t<double> states(const Curve& curve, double step) {
    const std::vector<CurvePoint> points = sampled(curve, step);
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{4}});
    double* out = array.mutable_data();
    for (const CurvePoint& p : points)
        for (const double x : {p.pose.at.x, p.pose.at.y, p.pose.heading, p.curvature}) *out++ = x;
    return array;
}

py::list connections(const Planned& planned, double step) {
    if (!(step > 0)) throw Refused{{"step", "is not above 0", "write metres, such as 0.02"}};
    py::list rows;
    for (const PlannedConnection& c : planned.plan->connections) {
        py::dict row;
        row["from"] = c.from;
        row["to"] = c.to;
        row["turn_before"] = c.turn_before;
        row["turn_after"] = c.turn_after;
        row["states"] = states(c.curve, step);
        rows.append(row);
    }
    return rows;
}

py::list spots(const std::vector<Spot>& all) {
    py::list rows;
    for (const Spot& spot : all) {
        py::dict row;
        row["what"] = spot.what;
        row["at"] = py::make_tuple(spot.at.x, spot.at.y);
        row["amount"] = spot.amount;
        rows.append(row);
    }
    return rows;
}

py::list stops(const Planned& planned) {
    py::list rows;
    for (const Stop& stop : planned.plan->stops) {
        py::dict row;
        row["why"] = stop.why;
        row["stroke"] = stop.stroke;
        row["time"] = stop.time;
        rows.append(row);
    }
    return rows;
}

}  // namespace

void add_columns(py::class_<Planned>& type) {
    using py::arg;
    type.def("samples", &samples)
        .def("elements", &elements, arg("tolerance"))
        .def("strokes", &strokes, arg("step"))
        .def("connections", &connections, arg("step"))
        .def("stops", &stops)
        .def(
            "spots",
            [](const Planned& p, const std::string& kind) {
                const Plan& plan = *p.plan;
                return spots(kind == "undrivable" ? plan.undrivable
                             : kind == "bare"     ? plan.bare
                                                  : plan.blemishes);
            },
            arg("kind"));
}

}  // namespace strandline::python
