// Is every element drawn once, and where it should be?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/nearest/nearest.hpp"
#include "result/check/faults.hpp"

namespace strandline::check {
namespace {

// Lengths are shares of the tolerance, which follows the canvas.
/// Chords that stand for an element's exact path leave it by this at most; far below the tolerance.
constexpr double chord_error = 0.01;
/// Metres between the places of a path that are looked for in what was drawn.
constexpr double place_step = 1;
constexpr double most_places = 200'000;
/// Metres: less is the fit of the rake path, not a rounded corner.
constexpr double worth_explaining = 0.1;
/// Radians: less than this is a chord of a curve, not a corner: rounding it with the corner's radius moves it
/// by under 0.3 %.
constexpr double corner_turn = 0.15;
/// Radians round corner.threshold in which either treatment of a corner may have been chosen.
constexpr double threshold_slack = 0.05;
/// Drawn length over the path's: a share for samples and fit, metres for the ends.
constexpr double length_share = 0.02, length_ends = 5;
/// Metres: a gap that long in a drawn line is a piece left out.
constexpr double gap = 2;
/// Metres outside the field that an element may lie and still be looked for.
constexpr double far_outside = 1000;

/// Where rounding a corner on the inside takes the rake off the path: `cut` is from the corner to the rake
/// path, `aside` from the rake path to the edges.
struct Rounding {
    Point at;
    double reach, cut, aside;
};

/// An arc of radius r inside a corner of turn 2 h begins r tan(h) before it and passes it at r (1/cos(h) -
/// 1). Where the edges are shorter than that, so is the arc: with tangent length t the distance is t tan(h /
/// 2).
std::vector<Rounding> roundings(const Polyline& line, bool closed,
                                const strandline::Options::Corner& corner) {
    struct Turn {
        std::size_t vertex;
        double turn, arc;
    };
    std::vector<Turn> turns;
    double arc = 0;
    const std::size_t n = line.size();
    for (std::size_t k = 0; k < n; ++k) {
        if (k > 0) arc += distance(line[k - 1], line[k]);
        if (!closed && (k == 0 || k + 1 == n)) continue;
        const Point in = line[k] - line[(k + n - 1) % n], out = line[(k + 1) % n] - line[k];
        const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
        if (turn > corner_turn) turns.push_back({k, turn, arc});
    }
    const double whole = arc + (closed ? distance(line.back(), line.front()) : 0);
    std::vector<Rounding> all;
    for (std::size_t k = 0; k < turns.size(); ++k) {
        const double turn = turns[k].turn;
        const bool small = turn < corner.threshold + threshold_slack && corner.below == "round";
        const bool large = turn > corner.threshold - threshold_slack && corner.above == "round";
        if (!small && !large) continue;
        const double last = k > 0 ? turns[k - 1].arc : closed ? turns.back().arc - whole : 0;
        const double next = k + 1 < turns.size() ? turns[k + 1].arc
                            : closed             ? turns.front().arc + whole
                                                 : whole;
        const double edge = std::min(turns[k].arc - last, next - turns[k].arc);
        const double h = std::min(turn / 2, pi / 2 - 1e-9);
        const double reach = std::min(corner.radius * std::tan(h), edge);
        all.push_back(
            {line[turns[k].vertex], reach, reach * std::tan(h / 2), reach * std::tan(h / 2) * std::cos(h)});
    }
    return all;
}

/// The largest `part` of the roundings that reach as far as p.
double explained(const std::vector<Rounding>& all, double Rounding::*part, Point p, double tolerance) {
    double most = 0;
    for (const Rounding& r : all)
        if (r.*part > most && distance(p, r.at) <= r.reach + tolerance) most = r.*part;
    return most;
}

/// The samples that draw one element.
struct Drawn {
    struct Place {
        int sample, stroke;
        Point at;  ///< of the middle of the lowered pins
    };
    std::vector<Place> places;  ///< both ends of every interval, each sample once
    SegmentTree::Segments segments;
};

std::string name_of_element(const Plan& plan, int element) {
    const Element& e = plan.drawing.elements[static_cast<std::size_t>(element)];
    return e.id.empty() ? fmt::format("element {}", element) : fmt::format("element {} ({})", element, e.id);
}

class Judge {
  public:
    Judge(const Plan& plan, const Options& options, Faults& faults, Report& report)
        : plan_(plan),
          options_(options),
          faults_(faults),
          report_(report),
          drawn_(plan.drawing.elements.size()) {}

    void gather() {
        std::vector<double> by_stroke(plan_.strokes.size(), 0);
        for (std::size_t i = 0; i + 1 < plan_.samples.size(); ++i) {
            const Sample &a = plan_.samples[i], &b = plan_.samples[i + 1];
            if (a.motion != Motion::draw) continue;
            const double step = distance(a.rake, b.rake);
            report_.drawn += step;
            const int element = element_of(plan_, a);
            if (element < 0 || element >= static_cast<int>(drawn_.size())) {
                faults_.add(
                    1, {Law::drawn_right,
                        fmt::format("draws stroke {} of element {}, which is not there", a.stroke, element),
                        a.rake, static_cast<int>(i), a.stroke, element});
                continue;
            }
            const Point from = drawn_at(plan_.robot, a, a.mask), to = drawn_at(plan_.robot, b, a.mask);
            Drawn& drawn = drawn_[static_cast<std::size_t>(element)];
            if (drawn.places.empty() || drawn.places.back().sample != static_cast<int>(i))
                drawn.places.push_back({static_cast<int>(i), a.stroke, from});
            drawn.places.push_back({static_cast<int>(i) + 1, a.stroke, to});
            drawn.segments.emplace_back(from, to);
            by_stroke[static_cast<std::size_t>(a.stroke)] += step;
        }
        for (std::size_t k = 0; k < by_stroke.size(); ++k) strokes_once(k, by_stroke[k]);
    }

    void judge() {
        const Box near = grown(field_of(plan_), far_outside);
        for (std::size_t e = 0; e < drawn_.size(); ++e) {
            const Element& element = plan_.drawing.elements[e];
            if (const auto* region = std::get_if<RegionElement>(&element.what)) {
                fill(static_cast<int>(e), region->region);
                continue;
            }
            const Path& path = std::get<LineElement>(element.what).path;
            const Box box = bounds(path);
            if (!box.empty() && contains(near, box.low) && contains(near, box.high))
                line(static_cast<int>(e), path);
            else
                faults_.add(1, {Law::drawn_right,
                                name_of_element(plan_, static_cast<int>(e)) + " lies far outside the field",
                                path.start, -1, -1, static_cast<int>(e)});
        }
    }

  private:
    /// What cannot be seen on the ground: a stroke gone over again, or the same fill stroke planned twice.
    void strokes_once(std::size_t k, double length_drawn) {
        const Stroke& stroke = plan_.strokes[k];
        if (stroke.element < 0 || stroke.element >= static_cast<int>(drawn_.size()) ||
            stroke.rake_path.empty())
            return;
        const double planned = length(stroke.rake_path);
        const Point at = stroke.rake_path.front().start.at;
        const auto fault = [&](std::string what) {
            faults_.add(1, {Law::drawn_once, std::move(what), at, -1, static_cast<int>(k), stroke.element});
        };
        const std::string whose = fmt::format("stroke {} of {}", k, name_of_element(plan_, stroke.element));
        const Element& element = plan_.drawing.elements[static_cast<std::size_t>(stroke.element)];
        if (const auto* line = std::get_if<LineElement>(&element.what);
            line != nullptr && line->pins != stroke.pins)
            faults_.add(
                1, {Law::pins,
                    fmt::format("{} is drawn with {} pins, allowed {}", whose, stroke.pins, line->pins), at,
                    -1, static_cast<int>(k), stroke.element});
        // A line's own length and places say it all.
        const bool fill = std::holds_alternative<RegionElement>(
            plan_.drawing.elements[static_cast<std::size_t>(stroke.element)].what);
        if (fill && length_drawn > planned * (1 + length_share) + length_ends * options_.tolerance)
            fault(fmt::format("{} is drawn more than once: {:.3f} m drawn of {:.3f} m", whose, length_drawn,
                              planned));
        else if (fill && length_drawn == 0 && planned > gap * options_.tolerance)
            fault(fmt::format("{} is not drawn: 0 m of {:.3f} m", whose, planned));
        for (std::size_t other = 0; other < k; ++other)
            if (plan_.strokes[other].element == stroke.element &&
                plan_.strokes[other].rake_path == stroke.rake_path)
                fault(fmt::format("{} is stroke {} again", whose, other));
    }

    void line(int element, const Path& path) {
        const Drawn& drawn = drawn_[static_cast<std::size_t>(element)];
        const Polyline chords = flattened(path, chord_error * options_.tolerance);
        if (chords.size() < 2) return;
        const SegmentTree::Segments segments = segments_of(chords, path.closed);
        double whole = 0;
        for (const auto& [a, b] : segments) whole += distance(a, b);
        const std::vector<Rounding> rounded = roundings(chords, path.closed, plan_.options.corner);

        const SegmentTree target(segments);
        for (const auto& [k, stroke, at] : drawn.places) {
            const double off = target.distance(at);
            const double beyond = off - (off > worth_explaining * options_.tolerance
                                             ? explained(rounded, &Rounding::aside, at, options_.tolerance)
                                             : 0);
            report_.worst_offset = std::max(report_.worst_offset, beyond);
            if (beyond > options_.tolerance)
                faults_.add(beyond,
                            {Law::drawn_right,
                             fmt::format("the rake is {:.4f} m off {}, allowed {:.4f} m", off,
                                         name_of_element(plan_, element), options_.tolerance + off - beyond),
                             at, k, stroke, element});
        }
        // A detour off the path is named above; it does not draw the path again.
        double on_path = 0;
        for (const auto& [a, b] : drawn.segments) {
            const Point middle = between(a, b, 0.5);
            const double off = target.distance(middle);
            if (off <=
                options_.tolerance + (off > worth_explaining * options_.tolerance
                                          ? explained(rounded, &Rounding::aside, middle, options_.tolerance)
                                          : 0))
                on_path += distance(a, b);
        }
        if (on_path > whole * (1 + length_share) + length_ends * options_.tolerance)
            faults_.add(1, {Law::drawn_once,
                            fmt::format("{} is drawn more than once: {:.3f} m drawn of {:.3f} m",
                                        name_of_element(plan_, element), on_path, whole),
                            chords.front(), -1, -1, element});
        missing(element, segments, whole, SegmentTree(drawn.segments), rounded);
    }

    void missing(int element, const SegmentTree::Segments& path, double whole, const SegmentTree& drawn,
                 const std::vector<Rounding>& rounded) {
        const double step = std::max(place_step * options_.tolerance, whole / most_places);
        double left_out = 0, run = 0, longest = 0;
        Point begin{}, worst{};
        for (const auto& [a, b] : path) {
            const int parts = static_cast<int>(std::ceil(distance(a, b) / step));
            for (int k = 0; k < parts; ++k) {
                const Point p = between(a, b, (k + 0.5) / parts);
                const double off = drawn.distance(p);
                if (off <= options_.tolerance ||
                    off <= options_.tolerance + explained(rounded, &Rounding::cut, p, options_.tolerance)) {
                    run = 0;
                    continue;
                }
                if (run == 0) begin = p;
                run += distance(a, b) / parts;
                left_out += distance(a, b) / parts;
                if (run > longest) {
                    longest = run;
                    worst = begin;
                }
            }
        }
        if (longest > gap * options_.tolerance)
            faults_.add(1, {Law::drawn_once,
                            fmt::format("{} is {}: {:.3f} m of {:.3f} m left out, {:.3f} m in one piece",
                                        name_of_element(plan_, element),
                                        left_out > 0.95 * whole ? "not drawn" : "not drawn whole", left_out,
                                        whole, longest),
                            worst, -1, -1, element});
    }

    void fill(int element, const Region& region) {
        const Drawn& drawn = drawn_[static_cast<std::size_t>(element)];
        if (drawn.places.empty() || region.outer.size() < 3) return;
        const BandedRegion area(region);
        SegmentTree::Segments edges = segments_of(region.outer, true);
        for (const Polygon& hole : region.holes)
            for (const auto& edge : segments_of(hole, true)) edges.push_back(edge);
        const SegmentTree outline(edges);
        for (const auto& [k, stroke, at] : drawn.places) {
            const Sample& s = plan_.samples[static_cast<std::size_t>(k)];
            for (const Point& middle : middles_of(s)) {
                if (area.contains(middle)) continue;
                const double off = outline.distance(middle);
                report_.worst_offset = std::max(report_.worst_offset, off);
                if (off > options_.tolerance)
                    faults_.add(
                        off,
                        {Law::drawn_right,
                         fmt::format("the middle of lowered pins is {:.4f} m outside {}, allowed {:.4f} m",
                                     off, name_of_element(plan_, element), options_.tolerance),
                         middle, k, stroke, element});
            }
        }
    }

    /// Of each row of neighbouring pins that are down.
    std::vector<Point> middles_of(const Sample& sample) const {
        const Robot& robot = plan_.robot;
        std::vector<Point> middles;
        const auto down = [&](int pin) {  // from the left
            return pin < robot.pins && (sample.mask >> (robot.pins - 1 - pin) & 1U) != 0;
        };
        for (int pin = 0; pin < robot.pins; ++pin) {
            if (!down(pin)) continue;
            int end = pin;
            while (down(end)) ++end;
            const double left = (robot.pins - pin - end) * robot.pin_pitch / 2;
            middles.push_back(sample.rake + left * left_normal(unit(sample.pose.heading)));
            pin = end;
        }
        return middles;
    }

    const Plan& plan_;
    const Options& options_;
    Faults& faults_;
    Report& report_;
    std::vector<Drawn> drawn_;
};

}  // namespace

void check_drawn(const Plan& plan, const Options& options, Faults& faults, Report& report) {
    Judge judge(plan, options, faults, report);
    judge.gather();
    judge.judge();
}

}  // namespace strandline::check
