#include "path/tour/tour.hpp"

#include <algorithm>

#include "path/tour/exact.hpp"
#include "path/tour/model.hpp"
#include "path/tour/order.hpp"
#include "path/tour/search.hpp"

namespace strandline::tour {
namespace {

/// Legs the proof may look at: half a second; what is hopeless is given up within a tenth.
constexpr std::uint64_t exact_work = 30'000'000;
/// A piece. The better the tour, the fewer states a proof meets.
constexpr std::uint64_t moves_before_proof = 10;

/// Where a drive and its reverse are as long: of the two, the one that begins with the earlier piece. Else
/// the last digit of a sum would decide, and with it the compiler.
std::vector<Visit> in_first_sense(const Model& model, std::vector<Visit> order) {
    const Problem& problem = *model.problem;
    const bool either = !problem.start && problem.end != End::at_point && !model.rules.any;
    if (!either || order.empty()) return order;
    const Visit &first = order.front(), &last = order.back();
    if (first.piece < last.piece || (order.size() == 1 && !first.backward)) return order;
    std::reverse(order.begin(), order.end());
    for (Visit& visit : order)
        if (!model.is_polygon(visit.piece)) visit.backward = !visit.backward;
    return order;
}

}  // namespace

Outcome<Tour> solve(const Problem& problem, const Options& options, const Progress& progress) {
    const auto model = build_model(problem);
    if (!model) return tl::unexpected(model.error());
    const auto first = first_order(*model);
    if (!first) return tl::unexpected(first.error());

    // A small problem is proven from a short search: most often that leaves nothing to search for.
    const int pieces = model->piece_count();
    const std::uint64_t moves = options.moves > 0 ? options.moves : default_moves(pieces);
    const std::uint64_t visits =
        options.moves > 0 ? std::numeric_limits<std::uint64_t>::max() : default_visits;
    const bool small = pieces <= most_exact_pieces;
    const std::uint64_t before_proof =
        small ? std::min(moves, moves_before_proof * static_cast<std::uint64_t>(std::max(pieces, 1))) : moves;
    Progress short_search = progress;
    if (small) short_search.time_used = {};
    Searched searched = improve(*model, *first, options.seed, before_proof, short_search, visits);
    Tour tour;
    const auto state = [&](const std::vector<Visit>& order) {
        tour.steps = steps_of(*model, in_first_sense(*model, order));
        tour.length = length_of(problem, tour.steps);
    };
    tour.moves = searched.moves;
    tour.stopped = searched.stopped || (!small && progress.time_used);
    state(searched.order);
    if (!small || tour.stopped) return tour;
    if (const auto proven = prove(*model, searched.order, tour.length, exact_work, progress)) {
        tour.proven_optimal = true;
        state(*proven);
    } else if (moves > before_proof || progress.time_used) {
        searched = improve(*model, searched.order, options.seed + 1, moves - before_proof, progress, visits);
        tour.moves += searched.moves;
        tour.stopped = searched.stopped || progress.time_used;
        state(searched.order);
    }
    return tour;
}

}  // namespace strandline::tour
