#include "path/tour/climb.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::tour {
namespace {

/// Fewer nodes have no kick.
constexpr int fewest_nodes = 8;
/// Runs of a kick: long ones are repaired in more than one way, which is what finds something.
constexpr int long_runs = 50, strewn_share = 40;
/// Kicks of a new member, by piece, and their runs: so many that it differs everywhere.
constexpr double kicks_apart = 0.25;
constexpr int short_runs = 10;
constexpr double heated_share = 0.9;
/// Kicks between two looks at the budget.
constexpr int kicks_between_looks = 16;

/// In (0, 1].
double uniform(std::mt19937_64& random) {
    constexpr double steps = 9007199254740992.0;  // 2^53: the doubles of one binade
    return (static_cast<double>(random() >> 11) + 1) / steps;
}

/// False: it breaks a rule and was taken back.
bool kick(Search& search, Bridge& bridge, double& gain) {
    gain = bridge.evaluate(search);
    bridge.apply(search);
    if (search.tour.keeps_rules()) return true;
    search.touched.clear();
    search.tour.back(0);
    return false;
}

}  // namespace

void anneal(Search& search, Descent& descent, Budget& budget, Span span, double heat) {
    Sequence& tour = search.tour;
    if (tour.nodes() < fewest_nodes) return;
    Bridge bridge(long_runs, strewn_share);
    const double leg = tour.length() / std::max(1, tour.nodes() / 2);
    double allowed_loss = 0;
    for (int k = 0; !descent.ended(); ++k) {
        if (k % tour.nodes() == 0) find_longest(search);
        if (k % kicks_between_looks == 0) {
            const double gone = span.gone(budget);
            if (gone >= 1) break;
            allowed_loss = heat * leg * std::max(0.0, 1 - gone / heated_share);
        }
        ++budget.steps;
        double gain = 0;
        if (!kick(search, bridge, gain)) continue;
        gain += descent.run();
        if (gain < 0 && gain < allowed_loss * std::log(uniform(search.random))) {
            tour.back(0);
            continue;
        }
        if (gain > tour.model().tolerance) {
            for (int i = 0; i < 8; ++i) choose_vertices_around(search, bridge.nodes()[i] / 2);
            descent.run();
        }
        tour.forget();
    }
    if (descent.ended()) tour.back(0);
    tour.forget();
    search.touched.clear();
    if (choose_all_vertices(search) > 0) descent.run_wide();
    search.touched.clear();
    tour.forget();
}

void diverge(Search& search, Descent& descent) {
    Sequence& tour = search.tour;
    if (tour.nodes() < fewest_nodes) return;
    Bridge bridge(short_runs, 0);
    const int kicks = std::max(1, static_cast<int>(kicks_apart * tour.nodes() / 2));
    double gain = 0;
    for (int k = 0; k < kicks; ++k) {
        kick(search, bridge, gain);
        tour.forget();
    }
    find_longest(search);
    descent.run_wide();
    if (choose_all_vertices(search) > 0) descent.run_wide();
    search.touched.clear();
    tour.forget();
}

}  // namespace strandline::tour
