#include "path/order/order.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "path/order/candidates.hpp"
#include "path/order/draft.hpp"
#include "path/order/memory.hpp"
#include "path/order/parted.hpp"
#include "path/order/problem.hpp"
#include "path/order/senses.hpp"

namespace strandline::order {
const std::vector<Stroke>& strokes_of(const Group& group, int variant) {
    return variant < 0 ? group.work.strokes : group.variants[static_cast<std::size_t>(variant)].strokes;
}

Outcome<Ordered> ordered(const Job& whole, const Robot& robot, const Options& options,
                         const Progress& progress, Memory* memory) {
    Memory own;
    Memory::Kept& kept = *(memory ? memory : &own)->kept_;
    kept.begin();
    Parted parts = parted(whole, robot.rake_width());
    Job& job = parts.job;
    const auto tour = tour::solve(problem_of(job), options.tour, progress);
    if (!tour) return tl::unexpected(tour.error());
    const Choices choices = choices_of(job, tour->steps, robot, options);
    const std::vector<Going> goings = with_driven_senses(job, tour->steps, choices, robot);
    // Where turns cost nothing, straight gaps are what is driven, and nothing is rolled over.
    const bool curved = robot.min_radius > 0 && options.connect.style != connect::Style::straight;
    const bool searches =
        curved && !options.straight &&
        (options.tour.method == tour::Method::best || options.tour.method == tour::Method::exact);
    if (searches && !tour->groups.empty()) job.batches = tour->groups;
    Options driving = options;
    if (!searches) driving.avoid.on = false;
    // a row that is to stay is driven once, round what is hard
    Draft draft = curved ? searched(job, goings, choices, robot, driving, !searches, kept, progress)
                         : drafted(job, goings, robot, options, nullptr, kept, progress);
    kept.remember(job, draft.goings);
    Ordered answer = std::move(draft.ordered);
    put_together(answer, parts, whole);
    answer.tour = *tour;
    answer.tour.stopped |= draft.stopped;
    progress.report("driving", 1);
    return answer;
}

}  // namespace strandline::order
