#include "result/legibility/legibility.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "result/legibility/details.hpp"

namespace strandline::legibility {
namespace {

/// The widest of a closed outline, seen from its medial axis.
double widest(const Polygon& outline, double pin, Point& at) {
    const MedialAxis axis = medial_axis({counter_clockwise(outline), {}}, step_in_pins * pin);
    double most = 0;
    for (const MedialAxis::Node& node : axis.nodes)
        if (node.radius > most) {
            most = node.radius;
            at = node.at;
        }
    return 2 * most;
}

/// Nodes of a graph in pieces.
class Pieces {
  public:
    explicit Pieces(std::size_t nodes) : above_(nodes) {
        std::iota(above_.begin(), above_.end(), std::size_t{0});
    }
    std::size_t root(std::size_t i) {
        while (above_[i] != i) i = above_[i] = above_[above_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        above_[std::max(root(a), root(b))] = std::min(root(a), root(b));
    }

  private:
    std::vector<std::size_t> above_;
};

/// Pieces of the axis that are narrower than a pin and a pin long. One that is an area by itself is as wide
/// as its widest; one that hangs on wider sand is looked at where it does not taper, at its narrowest.
void find_narrow(const MedialAxis& axis, int element, double pin, std::vector<Detail>& details) {
    const std::size_t count = axis.nodes.size();
    const auto width = [&](std::size_t k) { return 2 * axis.nodes[k].radius; };
    Pieces all(count), even(count);
    std::vector<double> all_run(count, 0), even_run(count, 0);
    std::vector<bool> hangs(count, false), is_even(count, false);
    for (const int pass : {0, 1})  // joined first, then summed up by piece
        for (const MedialAxis::Edge& edge : axis.edges) {
            const auto a = static_cast<std::size_t>(edge.from), b = static_cast<std::size_t>(edge.to);
            const double way = distance(axis.nodes[a].at, axis.nodes[b].at);
            if (std::max(width(a), width(b)) >= pin) {
                if (pass == 1) hangs[all.root(width(a) < width(b) ? a : b)] = true;
                continue;
            }
            const bool tapers = std::abs(axis.nodes[a].radius - axis.nodes[b].radius) > tip_slope * way;
            if (pass == 0) {
                all.join(a, b);
                if (!tapers) even.join(a, b);
            } else {
                all_run[all.root(a)] += way;
                if (!tapers) even_run[even.root(a)] += way;
                if (!tapers) is_even[a] = is_even[b] = true;
            }
        }
    const std::size_t none = count;
    std::vector<std::size_t> found(count, none);
    for (std::size_t k = 0; k < count; ++k) {
        if (width(k) >= pin || width(k) < least_share * pin) continue;
        const bool hanging = hangs[all.root(k)];
        if (hanging && !is_even[k]) continue;
        std::size_t& best = found[hanging ? even.root(k) : all.root(k)];
        if (best == none || (hanging ? width(k) < width(best) : width(k) > width(best))) best = k;
    }
    for (const std::size_t k : found) {
        if (k == none) continue;
        const double run = hangs[all.root(k)] ? even_run[even.root(k)] : all_run[all.root(k)];
        if (run >= pin) details.push_back({Detail::Kind::narrow, element, axis.nodes[k].at, width(k), pin});
    }
}

}  // namespace

const char* meaning_of(Detail::Kind kind) {
    switch (kind) {
        case Detail::Kind::narrow:
            return "a part narrower than a pin";
        case Detail::Kind::hole:
            return "a hole narrower than a pin";
        case Detail::Kind::loop:
            return "a closed line that its own groove fills";
        case Detail::Kind::horn:
            return "the tip of a horn, a third of its length from its end";
        case Detail::Kind::gap:
            return "a gap that keeps less than a pin of clean sand";
    }
    return "";
}

Report report(const Drawing& drawing, const Robot& robot) {
    Report report;
    const double pin = robot.pin_pitch;
    for (std::size_t e = 0; e < drawing.elements.size(); ++e) {
        const int element = static_cast<int>(e);
        if (const auto* line = std::get_if<LineElement>(&drawing.elements[e].what)) {
            if (!line->path.closed) continue;
            const Polygon outline = without_duplicate_corners(flattened(line->path, pin / 20));
            const double groove = groove_width(robot, line->pins);
            const Box box = bounds(outline);
            // Inside a line lies what its groove's inner half leaves.
            if (outline.size() < 3 || std::min(box.width(), box.height()) > 4 * groove) continue;
            Point at{};
            const double width = widest(outline, pin, at);
            if (width > 0 && width < groove + pin)
                report.details.push_back({Detail::Kind::loop, element, at, width, groove + pin});
            continue;
        }
        const Region& region = std::get<RegionElement>(drawing.elements[e].what).region;
        if (region.outer.size() < 3) continue;
        const MedialAxis axis = medial_axis(region, step_in_pins * pin);
        find_narrow(axis, element, pin, report.details);
        find_horns(axis, element, pin, report.details);
        for (const Polygon& hole : region.holes) {
            Point at{};
            const double width = widest(hole, pin, at);
            if (width > least_share * pin && width < pin)
                report.details.push_back({Detail::Kind::hole, element, at, width, pin});
        }
    }
    report.whole = find_gaps(drawing, robot, report.details);
    std::ranges::stable_sort(report.details, {}, [](const Detail& d) { return d.width / d.needed; });
    if (!report.details.empty()) report.factor = report.details.front().needed / report.details.front().width;
    return report;
}

}  // namespace strandline::legibility
