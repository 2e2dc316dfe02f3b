#include "path/tour/search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "path/tour/breed.hpp"
#include "path/tour/climb.hpp"
#include "path/tour/parts.hpp"

namespace strandline::tour {
namespace {

/// Owners in a candidate list.
constexpr int candidate_count = 8;
/// Moves when none are asked for: so many a piece up to `all_alike` pieces, then growing slower.
constexpr double default_moves_a_piece = 30, growth = 0.3;
constexpr int all_alike = 1'000;
constexpr std::uint64_t fewest_default_moves = 16'000;
/// So few find nothing new after `moves_of_few` a piece.
constexpr int few_pieces = 40;
constexpr std::uint64_t moves_of_few = 100;
/// Pieces that are worked on together: all members of a population of them stay below 100 MB.
constexpr int largest_part = 12'000;
/// The second time the parts are others, for what lay on their edges.
constexpr double first_share = 0.7, second_shift = 0.5;

double length_of_order(const Model& model, const std::vector<Visit>& order) {
    return Sequence(model, order).length();
}

/// Descent from the first order, wide: what is far from good comes near.
std::vector<Visit> descended(const Model& model, const Candidates& near, const std::vector<Visit>& first,
                             std::uint64_t seed, Budget& budget) {
    Search search{Sequence(model, first), near, std::mt19937_64(seed), {}, {}};
    Descent descent(search, budget);
    choose_all_vertices(search);
    find_longest(search);
    descent.touch_all();
    descent.run_wide();
    if (choose_all_vertices(search) > 0) descent.run_wide();
    return search.tour.order();
}

}  // namespace

std::uint64_t default_moves(int pieces) {
    const double n = std::max(pieces, 1);
    if (pieces <= few_pieces) return moves_of_few * static_cast<std::uint64_t>(n);
    const double moves =
        default_moves_a_piece * (n <= all_alike ? n : all_alike * std::pow(n / all_alike, growth));
    return std::max(fewest_default_moves, static_cast<std::uint64_t>(moves));
}

Searched improve(const Model& model, const std::vector<Visit>& first, std::uint64_t seed, std::uint64_t moves,
                 const Progress& progress, std::uint64_t most_visits) {
    const Candidates near = find_candidates(model, candidate_count);
    Budget budget{progress, moves, most_visits};
    Searched result;
    result.order = descended(model, near, first.empty() ? greedy_order(model, near) : first, seed, budget);
    const auto report = [&] {
        progress.report(fmt::format("rake up {:.6g}", length_of_order(model, result.order)),
                        std::min(1.0, budget.used()));
    };
    report();
    // What the descent took is what a member of a population takes, about.
    const double begin = std::min(1.0, budget.used());
    if (model.rules.any || model.piece_count() <= largest_part) {
        if (!budget.stopped) result.order = bred(model, near, result.order, seed, budget, {begin, 1}, begin);
    } else {
        double done = 0;
        for (const double shift : {0.0, second_shift}) {
            const double share = shift == 0 ? first_share : 1 - first_share;
            for (const auto& pieces : parts_of(model, largest_part, shift)) {
                if (budget.stopped) break;
                const Part part = part_of(model, near, result.order, pieces);
                const double part_share =
                    static_cast<double>(pieces.size()) / static_cast<double>(model.piece_count());
                const double end = done + share * part_share;
                const Span span{budget.used(), begin + (1 - begin) * end};
                result.order =
                    put_back(model, part,
                             bred(part.model, part.near, part.order, seed, budget, span, begin * part_share),
                             result.order);
                done = end;
                report();
            }
        }
    }
    report();
    result.moves = budget.steps / steps_per_move;
    result.stopped = budget.stopped;
    return result;
}

}  // namespace strandline::tour
