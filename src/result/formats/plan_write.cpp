#include "base/text/text.hpp"
#include "result/formats/formats.hpp"
#include "result/formats/plan_schema.hpp"

namespace strandline::formats {
namespace {

/// True for types that plan_schema.hpp describes: written as objects.
template <class T>
concept Described = requires(const T& value) {
    fields(value, [](const char*, const auto&) {});
};

SampleColumns columns_of(const std::vector<Sample>& samples) {
    SampleColumns columns;
    for (const Sample& sample : samples) {
        columns.t.push_back(sample.t);
        columns.x.push_back(sample.pose.at.x);
        columns.y.push_back(sample.pose.at.y);
        columns.heading.push_back(sample.pose.heading);
        columns.curvature.push_back(sample.curvature);
        columns.speed.push_back(sample.speed);
        columns.turn_rate.push_back(sample.turn_rate);
        columns.rake_x.push_back(sample.rake.x);
        columns.rake_y.push_back(sample.rake.y);
        columns.mask.push_back(sample.mask);
        columns.motion.push_back(sample.motion);
        columns.stroke.push_back(sample.stroke);
    }
    return columns;
}

/// One overload of put() a type. Arrays of objects get a line an item, so that a diff of two plans names what
/// differs.
class PlanWriter {
  public:
    explicit PlanWriter(Text& out) : out_(out) {}

    template <Described T>
    void put(const T& value) {
        bool first = true;
        add(out_, "{");
        fields(value, [&](const char* key, const auto& field) {
            name(key, first);
            put(field);
        });
        add(out_, "}");
    }
    template <Described T>
    void put(const std::vector<T>& values) {
        list(values, "\n", [&](const T& value) { put(value); });
    }
    void put(const Plan& plan) {
        add(out_, "{\n\"format\": ");
        put(std::string(plan_format_name));
        add(out_, ",\n\"version\": ");
        put(plan.version);
        fields(plan, [&](const char* key, const auto& field) {
            add(out_, ",\n");
            put(std::string(key));
            add(out_, ": ");
            put(field);
        });
        add(out_, "\n}\n");
    }

    void put(double value) { add_number(out_, value); }
    void put(int value) { add_number(out_, static_cast<long long>(value)); }
    void put(bool value) { add(out_, value ? "true" : "false"); }
    void put(const std::string& value) { add_string(out_, value); }
    template <class T>
    void put(const std::optional<T>& value) {
        value ? put(*value) : add(out_, "null");
    }
    void put(const std::vector<std::string>& values) {
        list(values, "", [&](const std::string& value) { put(value); });
    }

    void put(Point p) { numbers({p.x, p.y}); }
    void put(const Affine& m) { numbers({m.a, m.b, m.c, m.d, m.e, m.f}); }
    void put(const std::vector<double>& values) {
        list(values, "", [&](double value) { put(value); });
    }
    void put(const Polygon& polygon) {
        list(polygon, "", [&](Point p) { more(p.x, p.y); });
    }
    void put(const std::vector<Polygon>& polygons) {
        list(polygons, "", [&](const Polygon& polygon) { put(polygon); });
    }
    void put(const std::vector<Wheel>& wheels) {
        list(wheels, "", [&](const Wheel& wheel) { numbers({wheel.at.x, wheel.at.y, wheel.width}); });
    }
    void put(const std::vector<RakeRule>& rules) {
        list(rules, "", [&](const RakeRule& rule) {
            add(out_, "[");
            more(rule.up_to, rule.pins);
            add(out_, "]");
        });
    }
    void put(const std::vector<Node>& nodes) {
        list(nodes, "", [&](const Node& node) { more(node.s, node.at.x, node.at.y, node.drawn); });
    }
    void put(const Curve& curve) {
        add(out_, "[");
        more(curve.start.at.x, curve.start.at.y, curve.start.heading);
        for (const Clothoid& piece : curve.pieces) {
            add(out_, ",");
            more(piece.length, piece.curvature, piece.sharpness);
        }
        add(out_, "]");
    }
    void put(const std::vector<Curve>& curves) {
        list(curves, "", [&](const Curve& curve) { put(curve); });
    }
    void put(const Path& path) {
        add(out_, "[\"M\",");
        more(path.start.x, path.start.y);
        for (const Segment& segment : path.segments) std::visit([&](const auto& s) { put(s); }, segment);
        add(out_, path.closed ? ",\"Z\"]" : "]");
    }
    void put(const LineSegment& line) {
        add(out_, ",\"L\",");
        more(line.to.x, line.to.y);
    }
    void put(const CubicSegment& cubic) {
        add(out_, ",\"C\",");
        more(cubic.control1.x, cubic.control1.y, cubic.control2.x, cubic.control2.y, cubic.to.x, cubic.to.y);
    }
    void put(const ArcSegment& arc) {
        add(out_, ",\"A\",");
        more(arc.center.x, arc.center.y, arc.u.x, arc.u.y, arc.v.x, arc.v.y, arc.start, arc.sweep, arc.to.x,
             arc.to.y);
    }
    void put(const std::variant<LineElement, RegionElement>& what) {
        const auto* line = std::get_if<LineElement>(&what);
        add(out_, line ? "{\"line\":" : "{\"region\":");
        line ? put(*line) : put(std::get<RegionElement>(what).region);
        add(out_, "}");
    }

    void put(const Options& options) {
        bool first = true;
        add(out_, "{");
        for (const Setting& setting : settings()) {
            name(setting.key, first);
            put(get(options, setting.key));
        }
        add(out_, "}");
    }

    void put(const std::vector<Edit>& edits) {
        list(edits, "\n", [&](const Edit& edit) { std::visit([&](const auto& e) { put(e); }, edit); });
    }
    void put(const NodeName& node) {
        add(out_, "[");
        put(node.element);
        add(out_, ",");
        put(node.node);
        add(out_, "]");
    }
    void put(const LinkEdit& edit) {
        add(out_, "{\"edit\":\"link\",\"a\":");
        put(edit.a);
        add(out_, ",\"b\":");
        put(edit.b);
        add(out_, "}");
    }
    void put(const EntryEdit& edit) {
        add(out_, "{\"edit\":\"entry\",\"at\":");
        put(edit.at);
        add(out_, "}");
    }
    void put(const DirectionEdit& edit) {
        add(out_, "{\"edit\":\"direction\",\"element\":");
        put(edit.element);
        add(out_, ",\"direction\":");
        put(edit.direction);
        add(out_, "}");
    }

    void put(const HintEdit& edit) {
        add(out_, "{\"edit\":\"hint\",\"element\":");
        put(edit.element);
        add(out_, ",\"name\":");
        put(edit.name);
        add(out_, ",\"value\":");
        put(edit.value);
        add(out_, "}");
    }
    void put(const OrderEdit& edit) {
        add(out_, "{\"edit\":\"order\",\"elements\":");
        put(edit.elements);
        add(out_, "}");
    }
    void put(const DrawEdit& edit) {
        add(out_, "{\"edit\":\"draw\",\"element\":");
        put(edit.element);
        add(out_, ",\"paths\":");
        list(edit.paths, "", [&](const Path& path) { put(path); });
        add(out_, ",\"pins\":");
        put(edit.pins);
        add(out_, ",\"smooth\":");
        put(edit.smooth);
        add(out_, "}");
    }

    void put(const ThroughEdit& edit) {
        add(out_, "{\"edit\":\"through\",\"from\":");
        put(edit.from);
        add(out_, ",\"to\":");
        put(edit.to);
        add(out_, ",\"poses\":");
        list(edit.poses, "", [&](const Pose& pose) {
            add(out_, "[");
            put(pose.at.x);
            add(out_, ",");
            put(pose.at.y);
            add(out_, ",");
            put(pose.heading);
            add(out_, "]");
        });
        if (edit.hop) {
            add(out_, ",\"hop\":[");
            const auto& [from, to] = *edit.hop;
            put(from.x);
            for (const double value : {from.y, to.x, to.y}) {
                add(out_, ",");
                put(value);
            }
            add(out_, "]");
        }
        add(out_, "}");
    }

    void put(const std::vector<Sample>& samples) {
        const SampleColumns columns = columns_of(samples);
        const char* before = "{\n";
        fields(columns, [&](const char* key, const auto& column) {
            add(out_, before);
            put(std::string(key));
            add(out_, ":");
            put(column);
            before = ",\n";
        });
        add(out_, "}");
    }
    void put(Motion motion) { put(std::string(name_of(motion))); }
    void put(long long value) { add_number(out_, value); }
    void put(const std::vector<long long>& values) { runs(values); }
    void put(const std::vector<Motion>& values) { runs(values); }

  private:
    void name(const std::string& key, bool& first) {
        if (!first) add(out_, ",");
        first = false;
        put(key);
        add(out_, ":");
    }
    template <class... Numbers>
    void more(Numbers... values) {
        bool first = true;
        ((first ? void() : add(out_, ","), first = false, put(values)), ...);
    }
    void numbers(std::initializer_list<double> values) {
        list(values, "", [&](double value) { put(value); });
    }
    template <class Value>
    void runs(const std::vector<Value>& values) {
        add(out_, "[");
        for (std::size_t i = 0, n; i < values.size(); i += n) {
            for (n = 1; i + n < values.size() && values[i + n] == values[i];) ++n;
            if (i > 0) add(out_, ",");
            put(values[i]);
            add(out_, ",");
            put(static_cast<long long>(n));
        }
        add(out_, "]");
    }
    template <class Values, class Put>
    void list(const Values& values, const char* line, Put&& put_one) {
        bool first = true;
        add(out_, "[");
        for (const auto& value : values) {
            if (!first) add(out_, ",");
            first = false;
            add(out_, line);
            put_one(value);
        }
        add(out_, "]");
    }

    Text& out_;
};

}  // namespace

std::string write_plan(const Plan& plan) {
    Text text;
    PlanWriter(text).put(plan);
    return text;
}

std::string write_robot_json(const Robot& robot) {
    Text text;
    PlanWriter(text).put(robot);
    return text;
}

std::string write_edits(const std::vector<Edit>& edits) {
    Text text;
    PlanWriter(text).put(edits);
    return text;
}

}  // namespace strandline::formats
