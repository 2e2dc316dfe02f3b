// GeoJSON: RFC 7946. Longitude before latitude, outer rings counter-clockwise, no crs.
#include "base/text/text.hpp"
#include "result/exports/spans.hpp"
#include "result/sketch/sketch.hpp"

namespace strandline::exports {
namespace {

constexpr int degree_decimals = 9;     // 0.1 mm
constexpr double thinned_by = 0.0002;  // m: points of lines that straight lines show as well
constexpr int metre_decimals = 3, second_decimals = 3;

class Collection {
  public:
    Collection(const Plan& plan, const Site& site) : site_(site) {
        add(text_, "{\"type\": \"FeatureCollection\", \"name\": ");
        add_string(text_, plan.title);
        add(text_, ", \"features\": [");
    }
    /// Opens a feature: its properties follow by member(), then one geometry.
    void feature(std::string_view what) {
        add(text_, first_ ? "\n" : ",\n");
        first_ = false;
        add(text_, "{\"type\": \"Feature\", \"properties\": {\"what\": ");
        add_string(text_, what);
    }
    void member(std::string_view name, std::string_view value) {
        key(name);
        add_string(text_, value);
    }
    void member(std::string_view name, double value, int decimals) {
        key(name);
        add_fixed(text_, value, decimals);
    }
    void member(std::string_view name, int value) {
        key(name);
        add_number(text_, static_cast<long long>(value));
    }
    void line(const Polyline& points) {
        geometry("LineString");
        positions(points, false);
        add(text_, "}}");
    }
    void point(Point at) {
        geometry("Point");
        position(at);
        add(text_, "}}");
    }
    void polygon(const Region& region) {
        geometry("Polygon");
        add(text_, "[");
        positions(region.outer, true);
        for (const Polygon& hole : region.holes) {
            add(text_, ", ");
            positions(hole, true);
        }
        add(text_, "]}}");
    }
    std::string done() {
        add(text_, "\n]}\n");
        return std::move(text_);
    }

  private:
    void key(std::string_view name) {
        add(text_, ", ");
        add_string(text_, name);
        add(text_, ": ");
    }
    void geometry(std::string_view type) {
        add(text_, "}, \"geometry\": {\"type\": ");
        add_string(text_, type);
        add(text_, ", \"coordinates\": ");
    }
    void position(Point canvas) {
        const Geographic at = to_geographic(site_, canvas);
        add(text_, "[");
        add_fixed(text_, at.longitude, degree_decimals);
        add(text_, ", ");
        add_fixed(text_, at.latitude, degree_decimals);
        add(text_, "]");
    }
    void positions(const std::vector<Point>& points, bool closed) {
        add(text_, "[");
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) add(text_, ", ");
            position(points[i]);
        }
        if (closed && !points.empty()) {
            add(text_, ", ");
            position(points.front());
        }
        add(text_, "]");
    }

    const Site& site_;
    Text text_;
    bool first_ = true;
};

/// A line has two positions at least: where nothing is driven there is none.
Polyline thin(const Polyline& line) {
    Polyline kept;
    for (const std::size_t i : thinned(line, thinned_by)) kept.push_back(line[i]);
    return kept.size() < 2 || length(kept) < thinned_by ? Polyline{} : kept;
}

void add_fences(Collection& out, const Plan& plan) {
    const Canvas& canvas = plan.drawing.canvas;
    out.feature("canvas");
    out.polygon({{{0, 0}, {canvas.width, 0}, {canvas.width, canvas.height}, {0, canvas.height}}, {}});
    const DriveArea area = drive_area_of(plan);
    out.feature("border");
    out.polygon(area.border);
    for (const Region& keep_out : area.keep_out) {
        out.feature("keep-out");
        out.polygon(keep_out);
    }
}

void add_runs(Collection& out, const Plan& plan) {
    for (const sketch::Run& run : sketch::runs(plan.samples)) {
        Polyline robot, rake;
        for (std::size_t i = run.first; i <= run.last; ++i) {
            robot.push_back(plan.samples[i].pose.at);
            rake.push_back(plan.samples[i].rake);
        }
        const auto common = [&] {
            out.member("stroke", run.stroke);
            if (const Element* element = element_of(plan, run.stroke)) {
                out.member("element", element->id);
                out.member("layer", element->layer);
            }
            out.member("from_s", plan.samples[run.first].t, second_decimals);
            out.member("to_s", plan.samples[run.last].t, second_decimals);
        };
        if (const Polyline line = thin(rake); run.mask != 0 && !line.empty()) {
            out.feature("raked");
            common();
            out.member("pins", pins_down(run.mask));
            out.member("mask", static_cast<int>(run.mask));
            out.member("width", groove_width(plan.robot, pins_down(run.mask)), metre_decimals);
            out.line(line);
        }
        if (const Polyline line = thin(robot); !line.empty()) {
            out.feature(run.mask != 0 ? "driven, rake down" : "driven, rake up");
            common();
            out.line(line);
        }
    }
}

}  // namespace

Written geojson(const Plan& plan) {
    Written written;
    const Site site = site_of(plan, written.warnings);
    Collection out(plan, site);
    add_fences(out, plan);
    add_runs(out, plan);
    const auto stops = stop_samples(plan, plan.samples);
    for (std::size_t k = 0; k < stops.size() && !plan.samples.empty(); ++k) {
        out.feature("stop");
        out.member("why", plan.stops[k].why);
        out.member("from_s", plan.stops[k].time, second_decimals);
        out.point(plan.samples[stops[k]].pose.at);
    }
    written.files.push_back({".geojson", out.done()});
    return written;
}

}  // namespace strandline::exports
