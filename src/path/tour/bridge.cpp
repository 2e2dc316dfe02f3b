#include <algorithm>

#include "path/tour/moves.hpp"

namespace strandline::tour {
namespace {

/// Its links: two circles of two each.
constexpr int two_circles[] = {2, 4};
/// Steps of their walks.
constexpr int walk_steps = 4;

/// Four links near each other in the plane, wherever they are in the order: walks through the candidate lists
/// from one node. Places of their first nodes, ascending; false when they are not four.
bool strewn(Search& search, int* places) {
    const Sequence& tour = search.tour;
    const int loose_from = tour.model().loose_from;
    const int from = below(search.random, loose_from);
    for (int i = 0; i < 4; ++i) {
        int node = from;
        for (int s = 0; i > 0 && s < walk_steps; ++s) {
            const int first = search.candidates.first[static_cast<std::size_t>(node)];
            const int count = search.candidates.first[static_cast<std::size_t>(node + 1)] - first;
            if (count == 0) break;
            const int next =
                search.candidates.all[static_cast<std::size_t>(first + below(search.random, count))].node;
            if (next < loose_from) node = next ^ below(search.random, 2);
        }
        if (node >= loose_from) return false;
        const int place = tour.place_of(node);
        places[i] = (place & 1) ? place : place == 0 ? tour.nodes() - 1 : place - 1;
    }
    std::sort(places, places + 4);
    return std::adjacent_find(places, places + 4) == places + 4;
}

}  // namespace

double Bridge::evaluate(Search& search) {
    const Sequence& tour = search.tour;
    const int pieces = tour.nodes() / 2;
    int places[4], link[8];
    if (below(search.random, 100) >= strewn_ || !strewn(search, places)) {
        const int most = std::clamp((pieces - 1) / 3, 1, longest_run_);
        places[0] = 2 * below(search.random, pieces) + 1;
        for (int i = 1; i < 4; ++i) places[i] = places[i - 1] + 2 * (1 + below(search.random, most));
    }
    for (int i = 0; i < 4; ++i) {
        link[2 * i] = tour.node_at(places[i] % tour.nodes());
        link[2 * i + 1] = tour.mate(link[2 * i]);
    }
    // A|B, B|C, C|D, D|A become A|D, D|C, C|B, B|A: two circles of two links each.
    const auto [a, b, bb, c, cc, d, dd, aa] = link;
    const int circles[8] = {a, b, cc, d, dd, aa, bb, c};
    std::copy(circles, circles + 8, t_);
    return tour.gap(a, b) + tour.gap(bb, c) + tour.gap(cc, d) + tour.gap(dd, aa) - tour.gap(a, d) -
           tour.gap(dd, c) - tour.gap(cc, b) - tour.gap(bb, aa);
}

void Bridge::apply(Search& search) const {
    search.tour.exchange({t_, two_circles});
    search.touched.insert(search.touched.end(), t_, t_ + 8);
}

}  // namespace strandline::tour
