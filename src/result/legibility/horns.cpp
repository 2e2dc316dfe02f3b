// Horns: chains of the medial axis along which the radius grows from a tip, slowly enough that the end is
// sharp.
#include <algorithm>
#include <cmath>

#include "result/legibility/details.hpp"

namespace strandline::legibility {
namespace {

/// Metres of radius a metre of axis. Steeper is a corner of more than 50 degrees, or a spoke from the middle
/// of a rounding to its outline.
constexpr double blunt_slope = 0.42;
/// A horn counts by its width at this share of its length from the tip: what is thinner there is lost.
constexpr double looked_at = 1.0 / 3;

struct Graph {
    explicit Graph(const MedialAxis& axis) : ways(axis.nodes.size()) {
        for (const MedialAxis::Edge& edge : axis.edges) {
            const auto a = static_cast<std::size_t>(edge.from), b = static_cast<std::size_t>(edge.to);
            const double way = distance(axis.nodes[a].at, axis.nodes[b].at);
            if (std::abs(axis.nodes[a].radius - axis.nodes[b].radius) > blunt_slope * way) continue;
            ways[a].push_back(b);
            ways[b].push_back(a);
        }
    }
    std::vector<std::vector<std::size_t>> ways;  ///< without what is blunt
};

/// From the tip on, as long as it grows.
std::vector<std::size_t> horn_from(std::size_t tip, const Graph& graph, const MedialAxis& axis) {
    std::vector<std::size_t> horn{tip};
    for (std::size_t before = tip, at = graph.ways[tip].front();;) {
        if (axis.nodes[at].radius <= axis.nodes[before].radius) return horn;
        horn.push_back(at);
        if (graph.ways[at].size() != 2) return horn;
        const std::size_t next = graph.ways[at][graph.ways[at][0] == before ? 1 : 0];
        before = at;
        at = next;
    }
}

}  // namespace

void find_horns(const MedialAxis& axis, int element, double pin, std::vector<Detail>& details) {
    const auto width = [&](std::size_t node) { return 2 * axis.nodes[node].radius; };
    // An area that is narrower than a pin everywhere is named as such.
    if (std::ranges::none_of(axis.nodes, [&](const MedialAxis::Node& n) { return 2 * n.radius >= pin; }))
        return;
    const Graph graph(axis);
    for (std::size_t tip = 0; tip < axis.nodes.size(); ++tip) {
        if (graph.ways[tip].size() != 1 || width(tip) >= pin) continue;
        const std::vector<std::size_t> horn = horn_from(tip, graph, axis);
        double whole = 0, lost = 0, even = 0;
        for (std::size_t k = 1; k < horn.size(); ++k) {
            const double way = distance(axis.nodes[horn[k - 1]].at, axis.nodes[horn[k]].at),
                         from = width(horn[k - 1]), to = width(horn[k]);
            whole += way;
            if (from >= pin) continue;
            lost += to <= pin ? way : way * (pin - from) / (to - from);
            if (to - from <= 2 * tip_slope * way) even += way;
        }
        // What hardly tapers is named as narrow.
        if (lost < pin || even >= pin) continue;
        double gone = 0;
        for (std::size_t k = 1; k < horn.size(); ++k) {
            const double way = distance(axis.nodes[horn[k - 1]].at, axis.nodes[horn[k]].at),
                         left = looked_at * whole - gone;
            gone += way;
            if (left > way) continue;
            const double here = width(horn[k - 1]) + left / way * (width(horn[k]) - width(horn[k - 1]));
            if (here >= least_share * pin && here < pin)
                details.push_back({Detail::Kind::horn, element, axis.nodes[tip].at, here, pin});
            break;
        }
    }
}

}  // namespace strandline::legibility
