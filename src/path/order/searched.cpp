#include <algorithm>

#include "path/order/draft.hpp"
#include "path/order/sequence.hpp"

namespace strandline::order {
namespace {

/// Metres: what the search may spend on a move at first, and in later rounds.
constexpr double hot = 3, warm = 0.15;
/// Passages weighed: by group, and at most; later rounds have a share of that.
constexpr std::uint64_t work_by_group = 6'000, most_work = 4'000'000, later_share = 4;
/// Of a budget in moves: the tour's moves take about as long as so many passages.
constexpr std::uint64_t work_by_move = 50;
constexpr int most_rounds = 5;

std::vector<Going> goings_of(const Row& row, const Pairs& pairs) {
    std::vector<Going> goings;
    for (const int candidate : row) goings.push_back(pairs.all()[static_cast<std::size_t>(candidate)].going);
    return goings;
}

}  // namespace

Draft searched(const Job& job, const std::vector<Going>& goings, const Choices& choices, const Robot& robot,
               const Options& options, bool keep_row, Memory::Kept& kept, const Progress& progress) {
    Pairs pairs(job, choices, robot, options);
    Row row;
    for (const Going& going : goings) {
        const auto [first, end] = pairs.of_group(going.step.element);
        int candidate = first;
        while (candidate + 1 < end && !(pairs.all()[static_cast<std::size_t>(candidate)].going == going))
            ++candidate;
        row.push_back(candidate);
    }
    Made made;
    if (keep_row) {
        const Search search{pairs, made, row};
        return drafted(job, goings, robot, options, &search, kept, progress);
    }
    std::uint64_t work = std::min(work_by_group * row.size(), most_work);
    if (options.tour.moves > 0) work = std::min(work, work_by_move * options.tour.moves);
    Annealed found = annealed(
        std::move(row), job, pairs,
        {.hot = hot, .work = work, .least = work / later_share, .seed = options.tour.seed}, progress);
    bool stopped = found.stopped;
    row = std::move(found.row);
    std::optional<Draft> best;
    Row best_row;
    for (int round = 0; round < most_rounds; ++round) {
        const Search search{pairs, made, row};
        Draft draft = drafted(job, goings_of(row, pairs), robot, options, &search, kept, progress);
        if (!best || draft.cost < best->cost) {
            best = std::move(draft);
            best_row = row;
        }
        if (stopped) break;
        found = annealed(best_row, job, pairs,
                         {.hot = warm,
                          .work = work / later_share,
                          .seed = options.tour.seed + static_cast<std::uint64_t>(round)},
                         progress);
        stopped = found.stopped;
        const Row& next = found.row;
        if (next == row || next == best_row) break;
        row = next;
    }
    std::vector<int> before, after;
    for (const Going& going : goings) before.push_back(going.step.element);
    for (const int candidate : best_row) after.push_back(pairs.group_of(candidate));
    best->stopped = stopped;
    best->ordered.reordered = before != after;
    return std::move(*best);
}

}  // namespace strandline::order
