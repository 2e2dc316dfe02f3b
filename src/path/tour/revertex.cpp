#include <algorithm>
#include <limits>

#include "path/tour/moves.hpp"

namespace strandline::tour {
namespace {

/// Polygons on either side that are chosen anew together with one: what lies farther hardly feels it.
constexpr int reach_around = 4;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Point vertex(const Model& model, const Piece& piece, int v) {
    return model.choices[at(piece.first_choice + v)].at;
}

/// Best vertices of the polygons at places `from`, `from` + 2, ... (`count` of them, round the ring), the
/// nodes around them fixed.
double choose_run(Search& search, int from, int count) {
    Sequence& tour = search.tour;
    const Model& model = tour.model();
    const auto piece_at = [&](int k) { return tour.node_at((from + 2 * k) % tour.nodes()) / 2; };
    const int before = tour.mate(tour.node_at(from)),
              after = tour.mate(tour.node_at((from + 2 * count - 1) % tour.nodes()));
    std::vector<double> cost(1, 0), next;
    std::vector<std::vector<int>> came(at(count));
    double old = 0;
    for (int k = 0; k < count; ++k) {
        const Piece& piece = model.pieces[at(piece_at(k))];
        next.assign(at(piece.choices), std::numeric_limits<double>::infinity());
        came[at(k)].assign(at(piece.choices), 0);
        for (int v = 0; v < piece.choices; ++v) {
            const Point p = vertex(model, piece, v);
            if (k == 0) {
                next[at(v)] = before >= model.loose_from ? 0 : distance(tour.at(before), p);
                continue;
            }
            const Piece& last = model.pieces[at(piece_at(k - 1))];
            for (int u = 0; u < last.choices; ++u) {
                // sqrt only where it can matter: most vertices are beaten by their cost so far
                if (cost[at(u)] >= next[at(v)]) continue;
                if (const double d = cost[at(u)] + distance(vertex(model, last, u), p); d < next[at(v)]) {
                    next[at(v)] = d;
                    came[at(k)][at(v)] = u;
                }
            }
        }
        old += tour.gap(tour.node_at((from + 2 * k) % tour.nodes()),
                        tour.mate(tour.node_at((from + 2 * k) % tour.nodes())));
        cost.swap(next);
    }
    const int last_node = tour.node_at((from + 2 * count - 1) % tour.nodes());
    old += tour.gap(last_node, after);
    const Piece& last = model.pieces[at(piece_at(count - 1))];
    int best = 0;
    for (int v = 0; v < last.choices; ++v) {
        if (after < model.loose_from) cost[at(v)] += distance(vertex(model, last, v), tour.at(after));
        if (cost[at(v)] < cost[at(best)]) best = v;
    }
    const double gain = old - cost[at(best)];
    if (gain <= model.tolerance) return 0;
    for (int k = count - 1, v = best; k >= 0; --k) {
        const int piece = piece_at(k);
        const int u = came[at(k)][at(v)];
        if (tour.choice(piece) != v) {
            tour.choose(piece, v);
            search.touched.push_back(2 * piece);
            search.touched.push_back(2 * piece + 1);
        }
        v = u;
    }
    return gain;
}

}  // namespace

double Revertex::evaluate(const Search& search, int piece) {
    const Sequence& tour = search.tour;
    const Model& model = tour.model();
    if (!model.is_polygon(piece)) return 0;
    const int a = 2 * piece, before = tour.mate(a), after = tour.mate(a + 1);
    const bool entered = before < model.loose_from, left = after < model.loose_from;
    if (before / 2 == piece) return 0;  // alone in a ring
    const Piece& own = model.pieces[at(piece)];
    const double now = tour.gap(before, a) + tour.gap(a, after);
    double best = now - model.tolerance;
    choice_ = -1;
    for (int v = 0; v < own.choices; ++v) {
        const Point p = vertex(model, own, v);
        const double d =
            (entered ? distance(tour.at(before), p) : 0) + (left ? distance(p, tour.at(after)) : 0);
        if (d < best) {
            best = d;
            choice_ = v;
        }
    }
    piece_ = piece;
    return choice_ < 0 ? 0 : now - best;
}

void Revertex::apply(Search& search) const {
    search.tour.choose(piece_, choice_);
    search.touched.push_back(2 * piece_);
    search.touched.push_back(2 * piece_ + 1);
}

double choose_vertices_around(Search& search, int piece) {
    const Sequence& tour = search.tour;
    const Model& model = tour.model();
    if (!model.is_polygon(piece)) return 0;
    const int pieces = tour.nodes() / 2, middle = tour.place_of(2 * piece) / 2;
    const auto polygon = [&](int k) {
        return model.is_polygon(tour.node_at(2 * ((k + pieces) % pieces)) / 2);
    };
    int before = 0, after = 0;
    while (before < reach_around && before + 2 < pieces && polygon(middle - before - 1)) ++before;
    while (after < reach_around && before + after + 2 < pieces && polygon(middle + after + 1)) ++after;
    return choose_run(search, (2 * (middle - before) + tour.nodes()) % tour.nodes(), before + after + 1);
}

double choose_all_vertices(Search& search) {
    Sequence& tour = search.tour;
    const Model& model = tour.model();
    const int pieces = tour.nodes() / 2;
    const auto polygon = [&](int k) { return model.is_polygon(tour.node_at((2 * k) % tour.nodes()) / 2); };
    // Runs begin after a piece that has no choice. A ring of polygons alone is opened at one that keeps its
    // vertex.
    int start = 0;
    while (start < pieces && polygon(start)) ++start;
    start = start == pieces ? 0 : start;
    double gain = 0;
    for (int k = 1; k < pieces;) {
        int end = k;
        while (end < pieces && polygon(start + end)) ++end;
        if (end > k) gain += choose_run(search, (2 * (start + k)) % tour.nodes(), end - k);
        k = end + 1;
    }
    return gain;
}

}  // namespace strandline::tour
