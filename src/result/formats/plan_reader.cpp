// A parsed file taken apart into a Plan, strictly: every key of the schema, and no other.
#include "result/formats/plan_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "result/formats/json_place.hpp"
#include "result/formats/plan_schema.hpp"

namespace strandline::formats {
namespace {

/// Keys that files of this version did not always have: absent, they keep their defaults.
bool came_later(std::string_view key) {
    constexpr std::array<std::string_view, 12> later{"can_back_up", "lifts",        "setback",   "fix_noise",
                                                     "left_radius", "right_radius", "rake_side", "blemishes",
                                                     "in_driven",   "out_driven",   "border",    "keep_out"};
    return std::ranges::find(later, key) != later.end();
}

template <class T>
concept Described = requires(T& value) {
    fields(value, [](const char*, auto&) {});
};

/// One overload of get() a type; mirrors PlanWriter.
class PlanReader {
  public:
    template <Described T>
    void get(const At& at, T& value) {
        std::vector<std::string_view> known;
        fields(value, [&](const char* key, auto& field) {
            known.push_back(key);
            if (came_later(key) && at.value.is_object() && !at.value.contains(key)) return;
            get(child(at, key), field);
        });
        no_others(at, known);
    }
    template <Described T>
    void get(const At& at, std::vector<T>& values) {
        values.resize(array_at(at).size());
        for (std::size_t i = 0; i < values.size(); ++i) get(item(at, i), values[i]);
    }
    void get(const At& at, Plan& plan) {
        std::vector<std::string_view> known{"format", "version"};
        fields(plan, [&](const char* key, auto& field) {
            known.push_back(key);
            if (came_later(key) && at.value.is_object() && !at.value.contains(key)) return;
            get(child(at, key), field);
        });
        no_others(at, known);
    }

    void get(const At& at, double& value) { value = number(at); }
    void get(const At& at, int& value) {
        value = static_cast<int>(whole(at, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
    }
    void get(const At& at, bool& value) {
        if (!at.value.is_boolean()) mistyped(at, "true or false");
        value = at.value.get<bool>();
    }
    void get(const At& at, std::string& value) {
        if (!at.value.is_string()) mistyped(at, "a text");
        value = at.value.get_ref<const std::string&>();
    }
    template <class T>
    void get(const At& at, std::optional<T>& value) {
        if (!at.value.is_null()) get(at, value.emplace());
    }
    void get(const At& at, std::vector<std::string>& values) { each(at, values); }

    void get(const At& at, Point& p) {
        const auto n = exactly(at, 2);
        p = {n[0], n[1]};
    }
    void get(const At& at, Affine& m) {
        const auto n = exactly(at, 6);
        m = {n[0], n[1], n[2], n[3], n[4], n[5]};
    }
    void get(const At& at, std::vector<double>& values) { values = numbers(at); }
    void get(const At& at, Polygon& polygon) {
        groups_at(at, 2);
        const auto n = numbers(at);
        for (std::size_t i = 0; i < n.size(); i += 2) polygon.push_back({n[i], n[i + 1]});
    }
    void get(const At& at, std::vector<Polygon>& polygons) { each(at, polygons); }
    void get(const At& at, Wheel& wheel) {
        const auto n = exactly(at, 3);
        wheel = {{n[0], n[1]}, n[2]};
    }
    void get(const At& at, std::vector<Wheel>& wheels) { each(at, wheels); }
    void get(const At& at, RakeRule& rule) {
        if (array_at(at).size() != 2) refuse(at, "a rake rule is [up_to, pins]");
        get(item(at, 0), rule.up_to);
        get(item(at, 1), rule.pins);
    }
    void get(const At& at, std::vector<RakeRule>& rules) { each(at, rules); }
    void get(const At& at, std::vector<Node>& nodes) {
        const auto& values = groups_at(at, 4);
        nodes.resize(values.size() / 4);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            Node& node = nodes[i];
            node.s = number(item(at, 4 * i));
            node.at = {number(item(at, 4 * i + 1)), number(item(at, 4 * i + 2))};
            get(item(at, 4 * i + 3), node.drawn);
        }
    }
    void get(const At& at, Curve& curve) {
        const auto n = numbers(at);
        if (n.size() < 3 || n.size() % 3 != 0)
            refuse(at, fmt::format("a curve of {} numbers: x, y, heading, then three a piece", n.size()));
        curve.start = {{n[0], n[1]}, n[2]};
        for (std::size_t i = 3; i < n.size(); i += 3) curve.pieces.push_back({n[i], n[i + 1], n[i + 2]});
    }
    void get(const At& at, std::vector<Curve>& curves) {  // rake paths
        each(at, curves);
        for (std::size_t i = 0; i < curves.size(); ++i)
            if (std::ranges::any_of(curves[i].pieces, [](const Clothoid& piece) { return backs(piece); }))
                refuse(item(at, i), "a piece of negative length: no rake is pushed");
    }

    void get(const At& at, Path& path) { path = path_at(at); }
    void get(const At& at, std::variant<LineElement, RegionElement>& what) {
        if (at.value.is_object() && at.value.size() == 1 && at.value.contains("line"))
            get(child(at, "line"), what.emplace<LineElement>());
        else if (at.value.is_object() && at.value.size() == 1)
            get(child(at, "region"), what.emplace<RegionElement>().region);
        else
            refuse(at, "an element is either {\"line\": ...} or {\"region\": ...}");
    }

    void get(const At& at, Options& options) {
        std::vector<std::string_view> known;
        for (const Setting& setting : settings()) {
            known.push_back(setting.key);
            if (at.value.is_object() && !at.value.contains(setting.key)) continue;  // from before it was one
            const At place = child(at, setting.key);
            std::string text;
            get(place, text);
            if (const auto done = set(options, setting.key, text); !done)
                refuse(place, sentence(done.error()));
        }
        no_others(at, known);
    }

    void get(const At& at, std::vector<Edit>& edits) { each(at, edits); }
    void get(const At& at, Edit& edit) {
        std::string kind;
        get(child(at, "edit"), kind);
        if (kind == "link") {
            LinkEdit& link = edit.emplace<LinkEdit>();
            get(child(at, "a"), link.a);
            get(child(at, "b"), link.b);
            no_others(at, {"edit", "a", "b"});
        } else if (kind == "entry") {
            get(child(at, "at"), edit.emplace<EntryEdit>().at);
            no_others(at, {"edit", "at"});
        } else if (kind == "direction") {
            DirectionEdit& direction = edit.emplace<DirectionEdit>();
            get(child(at, "element"), direction.element);
            get(child(at, "direction"), direction.direction);
            no_others(at, {"edit", "element", "direction"});
        } else if (kind == "hint") {
            HintEdit& hint = edit.emplace<HintEdit>();
            get(child(at, "element"), hint.element);
            get(child(at, "name"), hint.name);
            get(child(at, "value"), hint.value);
            no_others(at, {"edit", "element", "name", "value"});
            if (const auto fine = valid(svg::Hint{hint.name, hint.value}); !fine)
                refuse(at, sentence(fine.error()));
        } else if (kind == "order") {
            get(child(at, "elements"), edit.emplace<OrderEdit>().elements);
            no_others(at, {"edit", "elements"});
        } else if (kind == "draw") {
            get(at, edit.emplace<DrawEdit>());
        } else if (kind == "through") {
            get(at, edit.emplace<ThroughEdit>());
        } else {
            refuse(
                child(at, "edit"),
                fmt::format("\"{}\" is no edit: link, entry, direction, hint, order, draw or through", kind));
        }
    }
    void get(const At& at, DrawEdit& draw) {
        get(child(at, "element"), draw.element);
        each(child(at, "paths"), draw.paths);
        get(child(at, "pins"), draw.pins);
        get(child(at, "smooth"), draw.smooth);
        no_others(at, {"edit", "element", "paths", "pins", "smooth"});
        if (draw.element.empty() || draw.paths.empty()) refuse(at, "a drawn element without name or lines");
        if (draw.pins < 1) refuse(child(at, "pins"), "a line is drawn with one pin at least");
        if (draw.smooth < 0) refuse(child(at, "smooth"), "less than nothing");
        for (std::size_t i = 0; i < draw.paths.size(); ++i) {
            const At path = child(at, "paths");
            if (draw.paths[i].segments.empty()) refuse(item(path, i), "a path without a segment");
        }
    }
    void get(const At& at, ThroughEdit& through) {
        get(child(at, "from"), through.from);
        get(child(at, "to"), through.to);
        each(child(at, "poses"), through.poses);
        if (at.value.contains("hop")) {
            const auto n = exactly(child(at, "hop"), 4);
            through.hop = {{n[0], n[1]}, {n[2], n[3]}};
            if (through.from != through.to)
                refuse(child(at, "hop"), "a drive within an area leads from it to itself");
        }
        no_others(at, {"edit", "from", "to", "poses", "hop"});
        if (through.poses.empty()) refuse(child(at, "poses"), "no pose to be led through");
        if (through.poses.size() > ThroughEdit::most_poses)
            refuse(child(at, "poses"),
                   fmt::format("{} poses to be led through; {} are the limit: leave some out",
                               through.poses.size(), ThroughEdit::most_poses));
    }
    void get(const At& at, Pose& pose) {
        const auto n = exactly(at, 3);
        pose = {{n[0], n[1]}, n[2]};
    }
    void get(const At& at, NodeName& node) {
        if (array_at(at).size() != 2) refuse(at, "a node is [element, number]");
        get(item(at, 0), node.element);
        get(item(at, 1), node.node);
    }

    void get(const At& at, std::vector<Sample>& samples) {
        rows_ = array_at(child(at, "t")).size();
        SampleColumns columns;
        get(at, columns);
        for (const auto* column : {&columns.x, &columns.y, &columns.heading, &columns.curvature,
                                   &columns.speed, &columns.turn_rate, &columns.rake_x, &columns.rake_y})
            if (column->size() != rows_)
                refuse(at, fmt::format("its columns differ in length: {} values of t, {} of another", rows_,
                                       column->size()));
        samples.resize(rows_);
        for (std::size_t i = 0; i < rows_; ++i)
            samples[i] = {columns.t[i],
                          {{columns.x[i], columns.y[i]}, columns.heading[i]},
                          columns.curvature[i],
                          columns.speed[i],
                          columns.turn_rate[i],
                          {columns.rake_x[i], columns.rake_y[i]},
                          static_cast<unsigned>(columns.mask[i]),
                          columns.motion[i],
                          static_cast<int>(columns.stroke[i])};
    }
    void get(const At& at, std::vector<long long>& values) {
        runs(at, values, [&](const At& place) {
            return whole(place, std::numeric_limits<int>::min(), std::numeric_limits<unsigned>::max());
        });
    }
    void get(const At& at, std::vector<Motion>& values) {
        runs(at, values, [&](const At& place) {
            std::string name;
            get(place, name);
            for (const Motion motion :
                 {Motion::draw, Motion::lead, Motion::loop, Motion::connect, Motion::pivot})
                if (name == name_of(motion)) return motion;
            refuse(place, fmt::format("\"{}\" is no motion", name));
        });
    }

  private:
    template <class T>
    void each(const At& at, std::vector<T>& values) {
        values.resize(array_at(at).size());
        for (std::size_t i = 0; i < values.size(); ++i) get(item(at, i), values[i]);
    }
    /// [value, count, ...]; the counts add up to the rows, which are known from a column written out: no
    /// count can ask for more memory.
    template <class T, class Read>
    void runs(const At& at, std::vector<T>& values, Read&& read) {
        const auto& pairs = groups_at(at, 2);
        for (std::size_t i = 0; i < pairs.size(); i += 2) {
            const T value = read(item(at, i));
            const auto left = static_cast<long long>(rows_ - values.size());
            values.insert(values.end(), static_cast<std::size_t>(whole(item(at, i + 1), 1, left)), value);
        }
        if (values.size() != rows_)
            refuse(at, fmt::format("its runs add up to {} samples of {}", values.size(), rows_));
    }
    std::size_t rows_ = 0;
};

}  // namespace

std::optional<Flaw> take_apart(const nlohmann::json& json, Plan& plan) {
    try {
        PlanReader().get(At{json}, plan);
    } catch (const Refused& refused) {
        return Flaw{refused.pointer, refused.reason};
    }
    return std::nullopt;
}

std::optional<Flaw> take_apart(const nlohmann::json& json, std::vector<Edit>& edits) {
    try {
        PlanReader().get(At{json}, edits);
    } catch (const Refused& refused) {
        return Flaw{refused.pointer, refused.reason};
    }
    return std::nullopt;
}

}  // namespace strandline::formats
