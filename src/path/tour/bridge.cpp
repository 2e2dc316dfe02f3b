#include <algorithm>

#include "path/tour/moves.hpp"

namespace strandline::tour {
namespace {

/// Pieces in a run at most: long enough to leave the basin, short enough that the repair stays local.
constexpr int longest_run = 10;

}  // namespace

double Bridge::evaluate(Search& search) {
    const Sequence& tour = search.tour;
    const int pieces = tour.nodes() / 2;
    const int most = std::clamp((pieces - 1) / 3, 1, longest_run);
    int place = 2 * below(search.random, pieces) + 1, link[8];
    for (int i = 0; i < 4; ++i) {
        link[2 * i] = tour.node_at(place % tour.nodes());
        link[2 * i + 1] = tour.mate(link[2 * i]);
        place += 2 * (1 + below(search.random, most));
    }
    // A|B, B|C, C|D, D|A become A|D, D|C, C|B, B|A: two circles of two links each.
    const auto [a, b, bb, c, cc, d, dd, aa] = link;
    const int circles[8] = {a, b, cc, d, dd, aa, bb, c};
    std::copy(circles, circles + 8, t_);
    return tour.gap(a, b) + tour.gap(bb, c) + tour.gap(cc, d) + tour.gap(dd, aa) - tour.gap(a, d) -
           tour.gap(dd, c) - tour.gap(cc, b) - tour.gap(bb, aa);
}

void Bridge::apply(Search& search) const {
    search.tour.exchange(t_, 4, 2);
    search.touched.insert(search.touched.end(), t_, t_ + 8);
}

}  // namespace strandline::tour
