#include "path/tour/search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "path/tour/assembly.hpp"
#include "path/tour/descent.hpp"
#include "path/tour/parts.hpp"

namespace strandline::tour {
namespace {

double env(const char* n, double d) { const char* v = std::getenv(n); return v ? std::atof(v) : d; }

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Owners in a candidate list. Ten rather than eight: clusters and drawings with doubled lines need the room.
constexpr std::uint64_t fewest_default_kicks = 16'000, most_default_kicks = 60'000;
/// Small enough that a proof is tried, so a short search will do.
constexpr std::uint64_t few_pieces = 40;
/// A loss of so many mean legs is accepted with chance 1/e at first, then less, and none in the last tenth.
constexpr double heated_share = 0.9;

/// In (0, 1].
double uniform(std::mt19937_64& random) {
    constexpr double steps = 9007199254740992.0;  // 2^53: the doubles of one binade
    return (static_cast<double>(random() >> 11) + 1) / steps;
}

/// What a search needs besides the problem.
struct Run_ {
    const Progress& progress;
    std::uint64_t most_visits;
    std::uint64_t moves = 0;   ///< kicks done
    std::uint64_t all = 0;     ///< kicks to do
    bool stopped = false;
    double best = 0;
};

/// Kicks and repairs at a falling heat. Ends where it is.
void anneal(Search& search, Descent& descent, std::uint64_t kicks, double first_heat, Run_& run) {
    Sequence& tour = search.tour;
    if (tour.nodes() < 8) return;
    Bridge bridge;
    const double leg = tour.length() / std::max(1, tour.nodes() / 2);
    const auto renewal = static_cast<std::uint64_t>(tour.nodes());
    for (std::uint64_t k = 0; k < kicks && !descent.ended(); ++k, ++run.moves) {
        if (k % renewal == 0) find_longest(search);
        const double share = static_cast<double>(k) / static_cast<double>(kicks);
        const double heat = first_heat * leg * std::max(0.0, 1 - share / heated_share);
        double gain = bridge.evaluate(search);
        bridge.apply(search);
        if (!tour.keeps_rules()) {
            search.touched.clear();
            tour.back(0);
            continue;
        }
        gain += descent.run(true);
        const double allowed = heat * std::log(uniform(search.random));
        if (gain < 0 && gain < allowed) {
            tour.back(0);
            continue;
        }
        if (gain > tour.model().tolerance) {
            for (int i = 0; i < 8; ++i) gain += choose_vertices_around(search, bridge.nodes()[i] / 2);
            descent.run(true);
        }
        tour.forget();
    }
    run.stopped = run.stopped || descent.stopped();
}

std::vector<Visit> refine(const Model& model, const Candidates& near, const std::vector<Visit>& first,
                          std::uint64_t seed, std::uint64_t kicks, double heat, Run_& run) {
    Search search{Sequence(model, first), near, std::mt19937_64(seed), {}, {}};
    Descent descent(search, run.progress, run.most_visits);
    const double before = search.tour.length();
    const double q = static_cast<double>(kicks) / std::max(1, model.piece_count());
    const int members = env("M",0)>0 ? static_cast<int>(env("M",0)) : model.rules.any || q < 16 ? 1 : std::clamp(static_cast<int>(q / 8), 4, 10);
    find_longest(search);
    if (members == 1) {
        anneal(search, descent, kicks, heat, run);
        if (choose_all_vertices(search) > 0) descent.run(false);
        search.touched.clear();
        return search.tour.length() < before ? search.tour.order() : first;
    }
    std::vector<Sequence> population;
    std::vector<double> lengths;
    const auto share = kicks / static_cast<std::uint64_t>(members);
    const Sequence start = search.tour;
    for (int m = 0; m < members; ++m) {
        search.tour = start;
        anneal(search, descent, share, heat, run);
        if (choose_all_vertices(search) > 0) descent.run(false);
        search.touched.clear();
        search.tour.forget();
        population.push_back(search.tour);
        lengths.push_back(search.tour.length());
        if (run.stopped) break;
    }
    const int count = static_cast<int>(population.size());
    if (std::getenv("V")) {double s=0;for(double l:lengths)s+=l; fprintf(stderr,"pop mean %.2f best %.2f\n",s/count,*std::min_element(lengths.begin(),lengths.end()));}
    std::vector<int> turn(at(count));
    for (int m = 0; m < count; ++m) turn[at(m)] = m;
    int generations = 0;
    for (bool gained = true; gained && count > 1 && !run.stopped && generations < 200; ++generations) {
        gained = false;
        for (std::size_t k = at(count); k > 1; --k)
            std::swap(turn[k - 1], turn[at(below(search.random, static_cast<int>(k)))]);
        const Sequence first_one = population[at(turn[0])];
        for (int m = 0; m < count; ++m) {
            Sequence& own = population[at(turn[at(m)])];
            std::swap(search.tour, own);
            const double gain =
                absorb(search, descent, m + 1 < count ? population[at(turn[at(m + 1)])] : first_one);
            std::swap(search.tour, own);
            gained = gained || gain > 0;
        }
    }
    int best = 0;
    for (int m = 0; m < count; ++m) {
        lengths[at(m)] = population[at(m)].length();
        if (lengths[at(m)] < lengths[at(best)]) best = m;
    }
    if (std::getenv("V")) {double s=0;for(double l:lengths)s+=l; fprintf(stderr,"gen %d mean %.2f best %.2f\n",generations,s/count,lengths[at(best)]);}
    std::swap(search.tour, population[at(best)]);
    if (choose_all_vertices(search) > 0) search.touched.clear();
    return search.tour.length() < before ? search.tour.order() : first;
}

}  // namespace

std::uint64_t default_kicks(int pieces) {
    // Up to a few hundred pieces well under a second, 1,000 in one second, a few seconds beyond.
    const auto n = static_cast<std::uint64_t>(std::max(pieces, 1));
    return n <= few_pieces ? 50 * n : std::clamp(30 * n, fewest_default_kicks, most_default_kicks);
}

Searched improve(const Model& model, const std::vector<Visit>& first, std::uint64_t seed, std::uint64_t kicks,
                 const Progress& progress, std::uint64_t most_visits) {
    const Candidates near = find_candidates(model, static_cast<int>(env("K",10)));
    Run_ run{progress, most_visits};
    Searched result;
    {
        Search search{Sequence(model, first), near, std::mt19937_64(seed), {}, {}};
        Descent descent(search, progress, most_visits);
        choose_all_vertices(search);
        find_longest(search);
        descent.touch_all();
        descent.run(false);
        if (choose_all_vertices(search) > 0) descent.run(false);
        result.order = search.tour.order();
        run.stopped = descent.stopped();
    }
    const int most = static_cast<int>(env("PART",1000));
    const double h = env("HEAT",0.7);
    if (model.rules.any || model.piece_count() <= 2*most) {
        if (!run.stopped) result.order = refine(model, near, result.order, seed, kicks, h, run);
    } else {
        const int passes = static_cast<int>(env("PASSES",2));
        for (int pass = 0; pass < passes; ++pass)
            for (const auto& pieces : parts_of(model, most, pass == 0 ? 0.0 : static_cast<double>(pass)/passes)) {
                if (run.stopped) break;
                const Part part = part_of(model, near, result.order, pieces);
                const auto share = kicks * pieces.size() / static_cast<std::size_t>(model.piece_count() * passes);
                const auto found = refine(part.model, part.near, part.order, seed+static_cast<std::uint64_t>(pass), share, pass?env("HEAT2",0.3):h, run);
                result.order = put_back(model, part, found, result.order);
            }
    }
    Search last{Sequence(model, result.order), near, std::mt19937_64(seed), {}, {}};
    choose_all_vertices(last);
    result.order = last.tour.order();
    result.moves = run.moves;
    result.stopped = run.stopped;
    return result;
}

}  // namespace strandline::tour
