// The middle lines of an area as paths.
#include "path/fill/axis.hpp"

#include <algorithm>

namespace strandline::fill {
namespace {

// A branch that reaches beyond its junction's disc by less is a corner's: 0.41 of the radius at a right
// corner.
constexpr double corner_reach = 0.45;
constexpr double least_reach = 0.35;  // of the width: nor is a shorter one worth a pass
constexpr double axis_step = 0.2;     // of the width
constexpr double tangent_over = 0.5;  // of the width: the end of a path points as it does over this

struct Graph {
    const MedialAxis& axis;
    std::vector<std::vector<int>> edges;  // by node: numbers of its edges
    std::vector<char> gone;               // by edge

    int other(int edge, int node) const {
        const MedialAxis::Edge& e = axis.edges[static_cast<std::size_t>(edge)];
        return e.from == node ? e.to : e.from;
    }
    std::vector<int> left(int node) const {
        std::vector<int> rest;
        for (int e : edges[static_cast<std::size_t>(node)])
            if (!gone[static_cast<std::size_t>(e)]) rest.push_back(e);
        return rest;
    }
    Point at(int node) const { return axis.nodes[static_cast<std::size_t>(node)].at; }
    double radius(int node) const { return axis.nodes[static_cast<std::size_t>(node)].radius; }
};

Graph graph_of(const MedialAxis& axis) {
    Graph g{axis, std::vector<std::vector<int>>(axis.nodes.size()), std::vector<char>(axis.edges.size(), 0)};
    for (std::size_t e = 0; e < axis.edges.size(); ++e) {
        g.edges[static_cast<std::size_t>(axis.edges[e].from)].push_back(static_cast<int>(e));
        g.edges[static_cast<std::size_t>(axis.edges[e].to)].push_back(static_cast<int>(e));
    }
    return g;
}

/// From a node along an edge as far as the way is the only one.
struct Branch {
    std::vector<int> nodes, edges;
};
Branch branch_from(const Graph& g, int node, int edge) {
    Branch branch{{node}, {}};
    while (true) {
        branch.edges.push_back(edge);
        const int next = g.other(edge, branch.nodes.back());
        branch.nodes.push_back(next);
        if (next == node) return branch;
        const std::vector<int> on = g.left(next);
        if (on.size() != 2) return branch;
        edge = on[0] == edge ? on[1] : on[0];
    }
}

void prune(Graph& g, double width) {
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<int> drop;
        for (int node = 0; node < static_cast<int>(g.axis.nodes.size()); ++node) {
            const std::vector<int> on = g.left(node);
            if (on.size() != 1) continue;
            const Branch branch = branch_from(g, node, on[0]);
            const int end = branch.nodes.back();
            if (g.left(end).size() < 3) continue;
            double length = g.radius(node);
            for (std::size_t i = 1; i < branch.nodes.size(); ++i)
                length += distance(g.at(branch.nodes[i - 1]), g.at(branch.nodes[i]));
            const double r = g.radius(end);
            if (length < r + std::max(corner_reach * r, least_reach * width))
                drop.insert(drop.end(), branch.edges.begin(), branch.edges.end());
        }
        for (int e : drop) g.gone[static_cast<std::size_t>(e)] = 1, changed = true;
    }
}

/// The direction in which a branch leaves its node.
Point leaving(const Graph& g, const std::vector<int>& nodes, bool from_end, double width) {
    const auto node = [&](std::size_t i) { return nodes[from_end ? nodes.size() - 1 - i : i]; };
    double so_far = 0;
    std::size_t i = 1;
    for (; i + 1 < nodes.size() && so_far < tangent_over * width + g.radius(node(0)); ++i)
        so_far += distance(g.at(node(i - 1)), g.at(node(i)));
    return normalized(g.at(node(i)) - g.at(node(0)));
}

struct Chain {
    std::vector<int> nodes;
    bool closed = false;
    bool cut_start = false, cut_end = false;  // ends at a path that goes on there
};

/// Branches, joined at their junctions two by two where they go on straightest.
std::vector<Chain> chains_of(const Graph& g, double width) {
    std::vector<Chain> chains;
    std::vector<char> used(g.axis.edges.size(), 0);
    const auto take = [&](int node, int edge) {
        const Branch branch = branch_from(g, node, edge);
        for (int e : branch.edges) used[static_cast<std::size_t>(e)] = 1;
        Chain chain{branch.nodes};
        if (branch.nodes.front() == branch.nodes.back()) chain.closed = true, chain.nodes.pop_back();
        chains.push_back(std::move(chain));
    };
    const auto sweep = [&](bool loops) {
        for (int node = 0; node < static_cast<int>(g.axis.nodes.size()); ++node) {
            const std::vector<int> on = g.left(node);
            if (loops ? on.size() != 2 : on.size() == 2) continue;
            for (int e : on)
                if (!used[static_cast<std::size_t>(e)]) take(node, e);
        }
    };
    sweep(false);
    sweep(true);
    // The junctions.
    for (int node = 0; node < static_cast<int>(g.axis.nodes.size()); ++node) {
        if (g.left(node).size() < 3) continue;
        struct End {
            std::size_t chain;
            bool at_end;
            Point out;
        };
        std::vector<End> ends;
        for (std::size_t c = 0; c < chains.size(); ++c) {
            if (chains[c].closed) continue;
            for (bool at_end : {false, true})
                if ((at_end ? chains[c].nodes.back() : chains[c].nodes.front()) == node)
                    ends.push_back({c, at_end, leaving(g, chains[c].nodes, at_end, width)});
        }
        std::size_t a = 0, b = 0;
        double straightest = -0.5;  // cosine: a path does not turn by more than 120 degrees
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = i + 1; j < ends.size(); ++j)
                if (const double c = -dot(ends[i].out, ends[j].out); c > straightest)
                    straightest = c, a = i, b = j;
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (a == b || (i != a && i != b))
                (ends[i].at_end ? chains[ends[i].chain].cut_end : chains[ends[i].chain].cut_start) = true;
        if (a == b) continue;
        Chain& first = chains[ends[a].chain];
        Chain& second = chains[ends[b].chain];
        if (ends[a].chain == ends[b].chain) {
            first.closed = true;
            first.nodes.pop_back();
            continue;
        }
        if (!ends[a].at_end) {
            std::ranges::reverse(first.nodes);
            std::swap(first.cut_start, first.cut_end);
        }
        if (ends[b].at_end) {
            std::ranges::reverse(second.nodes);
            std::swap(second.cut_start, second.cut_end);
        }
        first.nodes.insert(first.nodes.end(), second.nodes.begin() + 1, second.nodes.end());
        first.cut_end = second.cut_end;
        chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(ends[b].chain));
    }
    return chains;
}

/// The path without what lies within its first point's disc.
void cut_start(AxisPath& path) {
    const Point centre = path.line.front();
    const double r = path.radius.front();
    std::size_t i = 1;
    while (i + 1 < path.line.size() && distance(path.line[i], centre) < r) ++i;
    const double inner = distance(path.line[i - 1], centre), outer = distance(path.line[i], centre);
    if (outer > r) {  // where the chord leaves the disc, near enough: chords are short or begin in the centre
        const double t = (r - inner) / (outer - inner);
        --i;
        path.line[i] = between(path.line[i], path.line[i + 1], t);
        path.radius[i] += t * (path.radius[i + 1] - path.radius[i]);
    }
    path.line.erase(path.line.begin(), path.line.begin() + static_cast<std::ptrdiff_t>(i));
    path.radius.erase(path.radius.begin(), path.radius.begin() + static_cast<std::ptrdiff_t>(i));
}

/// Straight on from the path's end to the outline.
void draw_on(AxisPath& path, const Region& area, double width) {
    const double r = path.radius.back();
    Point back = path.line.front();
    for (std::size_t i = path.line.size(); i-- > 0;)
        if (distance(path.line[i], path.line.back()) >= tangent_over * width) {
            back = path.line[i];
            break;
        }
    const Point on = normalized(path.line.back() - back);
    if (const auto reach = reach_from({&area, 1}, path.line.back(), on);
        reach && reach->forward < 2 * r + width) {
        path.line.push_back(path.line.back() + reach->forward * on);
        path.radius.push_back(r);
    }
}

void turn_about(AxisPath& path) {
    std::ranges::reverse(path.line);
    std::ranges::reverse(path.radius);
}

/// An area without a long way through it: along its longest edge, through the widest disc.
std::vector<AxisPath> across(const Region& area, const MedialAxis& axis) {
    const auto widest = std::ranges::max_element(axis.nodes, {}, &MedialAxis::Node::radius);
    if (widest == axis.nodes.end()) return {};
    Point along{1, 0};
    double longest = 0;
    for (std::size_t i = 0, j = area.outer.size() - 1; i < area.outer.size(); j = i++)
        if (const double d = distance(area.outer[j], area.outer[i]); d > longest * (1 + 1e-9))
            longest = d, along = normalized(area.outer[i] - area.outer[j]);
    const auto reach = reach_from({&area, 1}, widest->at, along);
    if (!reach) return {};
    const double r = widest->radius;
    return {{{widest->at - reach->backward * along, widest->at, widest->at + reach->forward * along},
             {r, r, r},
             false}};
}

}  // namespace

std::optional<Reach> reach_from(std::span<const Region> area, Point from, Point along) {
    Reach reach{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    int ahead = 0;
    const auto ring = [&](const Polygon& polygon) {
        if (polygon.empty()) return;
        double a = cross(along, polygon.back() - from), b = 0;  // the hottest loop of combs
        for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++, a = b) {
            b = cross(along, polygon[i] - from);
            if ((a > 0) == (b > 0)) continue;
            const double t = dot(along, between(polygon[j], polygon[i], a / (a - b)) - from);
            if (t > 0) ++ahead;
            (t > 0 ? reach.forward : reach.backward) =
                std::min(t > 0 ? reach.forward : reach.backward, std::abs(t));
        }
    };
    for (const Region& part : area) {
        ring(part.outer);
        for (const Polygon& hole : part.holes) ring(hole);
    }
    if (ahead % 2 == 0 || !std::isfinite(reach.backward)) return std::nullopt;
    return reach;
}

std::vector<AxisPath> axis_paths(const Region& area, const Options& options) {
    const double w = options.width;
    const MedialAxis axis = medial_axis(area, axis_step * w);
    Graph g = graph_of(axis);
    prune(g, w);
    std::vector<AxisPath> paths;
    for (const Chain& chain : chains_of(g, w)) {
        AxisPath path;
        for (int node : chain.nodes) {
            path.line.push_back(g.at(node));
            path.radius.push_back(g.radius(node));
        }
        path.closed = chain.closed;
        if (!path.closed) {
            for (bool cut : {chain.cut_start, chain.cut_end}) {
                if (path.line.size() < 2) break;
                if (cut) cut_start(path);
                turn_about(path);
            }
            for (bool cut : {chain.cut_start, chain.cut_end}) {
                if (path.line.size() < 2) break;
                turn_about(path);  // the start is the end first, then the end is
                if (!cut) draw_on(path, area, w);
            }
        }
        if (path.line.size() >= 2) paths.push_back(std::move(path));
    }
    if (paths.empty()) return across(area, axis);
    std::ranges::stable_sort(
        paths, [](const AxisPath& a, const AxisPath& b) { return length(a.line) > length(b.line); });
    return paths;
}

}  // namespace strandline::fill
