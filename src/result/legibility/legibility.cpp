#include "result/legibility/legibility.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace strandline::legibility {
namespace {

/// Towards a corner of angle a the medial axis's radius falls by sin(a / 2) a metre: more than this is the
/// tip of a corner of 30 degrees or more, which loses less than a pin's own square.
constexpr double corner_slope = 0.26;
/// Metres of a curved medial axis that one chord stands for, in pins.
constexpr double step_in_pins = 0.5;
/// What is thinner than this share of a pin is a flaw of the outline, not a detail.
constexpr double least_share = 0.02;

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

/// Stretches of the axis that are narrower than a pin, each at its narrowest.
void find_narrow(const Region& region, int element, double pin, std::vector<Detail>& details) {
    const MedialAxis axis = medial_axis(region, step_in_pins * pin);
    std::vector<std::size_t> above(axis.nodes.size());
    std::iota(above.begin(), above.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (above[i] != i) i = above[i] = above[above[i]];
        return i;
    };
    std::vector<double> run(axis.nodes.size(), 0);
    std::vector<std::pair<std::size_t, double>> pieces;
    for (const MedialAxis::Edge& edge : axis.edges) {
        const auto a = static_cast<std::size_t>(edge.from), b = static_cast<std::size_t>(edge.to);
        const double way = distance(axis.nodes[a].at, axis.nodes[b].at);
        const double wide = 2 * std::max(axis.nodes[a].radius, axis.nodes[b].radius);
        if (wide >= pin || way <= 0) continue;
        if (std::abs(axis.nodes[a].radius - axis.nodes[b].radius) > corner_slope * way) continue;
        above[std::max(root(a), root(b))] = std::min(root(a), root(b));
        pieces.emplace_back(a, way);
    }
    for (const auto& [node, way] : pieces) run[root(node)] += way;
    std::vector<std::size_t> narrowest(axis.nodes.size(), axis.nodes.size());
    for (const auto& piece : pieces) {
        std::size_t& least = narrowest[root(piece.first)];
        const double radius = axis.nodes[piece.first].radius;
        if (2 * radius >= least_share * pin &&
            (least == axis.nodes.size() || radius < axis.nodes[least].radius))
            least = piece.first;
    }
    for (std::size_t k = 0; k < narrowest.size(); ++k) {
        if (narrowest[k] == axis.nodes.size()) continue;
        const MedialAxis::Node& node = axis.nodes[narrowest[k]];
        if (run[k] >= 2 * node.radius)
            details.push_back({Detail::Kind::narrow, element, node.at, 2 * node.radius, pin});
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
        find_narrow(region, element, pin, report.details);
        for (const Polygon& hole : region.holes) {
            Point at{};
            const double width = widest(hole, pin, at);
            if (width > least_share * pin && width < pin)
                report.details.push_back({Detail::Kind::hole, element, at, width, pin});
        }
    }
    std::ranges::stable_sort(report.details, {}, [](const Detail& d) { return d.width / d.needed; });
    if (!report.details.empty()) report.factor = report.details.front().needed / report.details.front().width;
    return report;
}

}  // namespace strandline::legibility
