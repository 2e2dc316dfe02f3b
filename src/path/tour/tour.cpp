#include "path/tour/tour.hpp"

#include <fmt/core.h>

#include "path/tour/model.hpp"
#include "path/tour/order.hpp"
#include "path/tour/search.hpp"

namespace strandline::tour {

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
    return tour;
}

}  // namespace strandline::tour
