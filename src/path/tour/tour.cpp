#include "path/tour/tour.hpp"

#include <fmt/core.h>

#include "path/tour/exact.hpp"
#include "path/tour/model.hpp"
#include "path/tour/order.hpp"
#include "path/tour/search.hpp"

namespace strandline::tour {
namespace {

/// Transitions the proof may take: about 0.1 s.
constexpr std::uint64_t exact_work = 3'000'000;

}  // namespace

Outcome<Tour> solve(const Problem& problem, const Options& options, const Progress& progress) {
    const auto model = build_model(problem);
    if (!model) return tl::unexpected(model.error());
    const auto first = first_order(*model);
    if (!first) return tl::unexpected(first.error());

    const std::uint64_t kicks = options.moves > 0 ? options.moves : default_kicks(model->piece_count());
    const Searched searched = improve(*model, *first, options.seed, kicks, progress);
    Tour tour;
    tour.moves = searched.moves;
    tour.stopped = searched.stopped;
    tour.steps = steps_of(*model, searched.order);
    tour.length = length_of(problem, tour.steps);
    if (tour.stopped) return tour;
    if (const auto proven = prove(*model, searched.order, tour.length, exact_work, progress)) {
        tour.proven_optimal = true;
        tour.steps = steps_of(*model, *proven);
        tour.length = length_of(problem, tour.steps);
    }
    return tour;
}

}  // namespace strandline::tour
