// .thr for sand tables: lines "theta rho", radians clockwise from the top without wrapping, rho 0 (centre) to
// 1 (rim). The ball never lifts, and between two lines it runs along an Archimedean spiral, so straight lines
// are cut until spirals stay on them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/text.hpp"
#include "result/exports/spans.hpp"

namespace strandline::exports {
namespace {

constexpr int decimals = 6;
constexpr double by_spirals = 5e-5;    // of the radius: 20 um on a table of 40 cm
constexpr double by_spirals_m = 5e-4;  // m on the canvas, at most
constexpr double by_thinning = 0.4;    // of both
constexpr double at_centre = 1e-9;     // of the radius: no direction there
constexpr double widest_turn = 0.5;    // radians between lines

struct Polar {
    double theta = 0, rho = 0;
};
/// Of the table: x to the right, y up, rho 1 at the rim.
Point point_of(Polar at) { return at.rho * Point{std::sin(at.theta), std::cos(at.theta)}; }

class Track {
  public:
    /// tolerance: of the radius.
    Track(std::string header, double tolerance) : text_(std::move(header)), tolerance_(tolerance) {}

    void begin(Point at) {
        at_ = at;
        polar_ = {length(at) > at_centre ? std::atan2(at.x, at.y) : 0, length(at)};
        line(polar_);
    }
    void go_to(Point to) { go_to(to, 0); }
    /// Straight in or out, without turning.
    void go_out(double rho) {
        polar_.rho = rho;
        at_ = point_of(polar_);
        line(polar_);
    }
    double rho() const { return polar_.rho; }
    std::string done() { return std::move(text_); }

  private:
    void go_to(Point to, int depth) {
        if (polar_.rho <= at_centre && length(to) > at_centre) {  // the ball stays, the arm turns
            polar_.theta += wrap_angle(std::atan2(to.x, to.y) - polar_.theta);
            line(polar_);
        }
        const double turn = length(to) > at_centre ? wrap_angle(std::atan2(to.x, to.y) - polar_.theta) : 0;
        const Polar end{polar_.theta + turn, length(to)};
        constexpr int deepest = 40;
        if (depth < deepest && leaves(to, end)) {
            const Point middle = between(at_, to, 0.5);
            go_to(middle, depth + 1);
            go_to(to, depth + 1);
            return;
        }
        polar_ = end;
        at_ = to;
        line(polar_);
    }
    /// Whether the spiral to `end` leaves the straight line.
    bool leaves(Point to, Polar end) const {
        if (std::max(polar_.rho, end.rho) > tolerance_ && std::abs(end.theta - polar_.theta) > widest_turn)
            return true;
        for (const double t : {0.25, 0.5, 0.75}) {
            const Polar middle{std::lerp(polar_.theta, end.theta, t), std::lerp(polar_.rho, end.rho, t)};
            if (distance_to_segment(point_of(middle), at_, to) > tolerance_) return true;
        }
        return false;
    }
    void line(Polar at) {
        add_fixed(text_, at.theta, decimals);
        add(text_, " ");
        add_fixed(text_, std::min(at.rho, 1.0), decimals);
        add(text_, "\n");
    }

    Text text_;
    double tolerance_;
    Point at_;
    Polar polar_;
};

/// What is raked, stroke after stroke, metres from the canvas's middle.
std::vector<Polyline> drawn_of(const Plan& plan, Point middle) {
    std::vector<Polyline> lines;
    for (const Span& span : spans_of(plan.samples)) {
        if (!span.down) continue;
        lines.push_back(tool_track(plan, span));
        for (Point& p : lines.back()) p = p - middle;
    }
    return lines;
}

void come_or_go(Track& track, const std::string& ends, double rho) {
    if (ends == "rim" || (ends == "nearest" && rho >= 0.5)) track.go_out(1);
    if (ends == "centre" || (ends == "nearest" && rho < 0.5)) track.go_out(0);
}

std::string header(const Plan& plan, Point middle, double radius) {
    std::string title = plan.title;
    std::ranges::replace_if(
        title, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return fmt::format("# {}\n# rho 1 is {:.6f} m from {:.6f} {:.6f} on the canvas\n", title, radius,
                       middle.x, middle.y);
}

}  // namespace

Outcome<Written> thr(const Plan& plan) {
    const Point middle{plan.drawing.canvas.width / 2, plan.drawing.canvas.height / 2};
    std::vector<Polyline> lines = drawn_of(plan, middle);
    double reach = 0;
    for (const Polyline& line : lines)
        for (const Point p : line) reach = std::max(reach, length(p));
    if (!(reach > 0)) return fail("thr", "nothing is drawn", "plan a drawing first");
    const double radius = plan.options.thr.radius > 0 ? plan.options.thr.radius : reach;
    if (reach > radius * (1 + 1e-9))
        return fail(
            "thr.radius",
            fmt::format("{:.3f} m is too little: the drawing reaches {:.3f} m from the canvas's middle",
                        radius, reach),
            "use that, or 0 for what holds all of it");
    const std::string& ends = plan.options.thr.ends;
    const double tolerance = std::min(by_spirals, by_spirals_m / radius);
    Track track(header(plan, middle, radius), tolerance);
    bool begun = false;
    for (const Polyline& line : lines)
        for (const std::size_t i : thinned(line, by_thinning * tolerance * radius)) {
            const Point at = (1 / radius) * line[i];
            if (begun) {
                track.go_to(at);
                continue;
            }
            begun = true;
            const double rho = length(at);
            const bool rim = ends == "rim" || (ends == "nearest" && rho >= 0.5);
            const Point out = rho > at_centre ? (1 / rho) * at : Point{0, 1};
            if (ends == "drawn")
                track.begin(at);
            else
                track.begin(rim ? out : Point{0, 0});
            track.go_to(at);
        }
    come_or_go(track, ends, track.rho());
    return Written{{{".thr", track.done()}},
                   {{"thr", "the ball never lifts: the straight ways between strokes are drawn as well"}}};
}

}  // namespace strandline::exports
