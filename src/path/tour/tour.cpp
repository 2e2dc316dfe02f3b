#include "path/tour/tour.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <thread>

#include "path/tour/exact.hpp"
#include "path/tour/grouped.hpp"
#include "path/tour/model.hpp"
#include "path/tour/neighbours.hpp"
#include "path/tour/order.hpp"
#include "path/tour/search.hpp"

namespace strandline::tour {
namespace {

/// Legs the proof may look at: half a second; what is hopeless is given up within a tenth.
constexpr std::uint64_t exact_work = 30'000'000;
/// Where nothing but the optimum will do: a minute, 400 MB.
constexpr std::uint64_t patient_work = 5'000'000'000;
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

/// The progress for several threads.
Progress shared(const Progress& progress, std::mutex& one_at_a_time, bool reports) {
    Progress own;
    own.report = [&, reports](const std::string& what, double share) {
        const std::lock_guard guard(one_at_a_time);
        if (reports) progress.report(what, share);
    };
    own.stopped = [&] {
        const std::lock_guard guard(one_at_a_time);
        return progress.stopped();
    };
    if (progress.time_used)
        own.time_used = [&] {
            const std::lock_guard guard(one_at_a_time);
            return progress.time_used();
        };
    return own;
}

/// The best of searches with different seeds, one a thread.
Searched improved(const Model& model, const std::vector<Visit>& first, const Options& options,
                  std::uint64_t moves, const Progress& progress) {
    const std::uint64_t visits =
        options.moves > 0 ? std::numeric_limits<std::uint64_t>::max() : default_visits;
    if (options.threads <= 1) return improve(model, first, options.seed, moves, progress, visits);
    std::mutex one_at_a_time;
    std::vector<Searched> found(static_cast<std::size_t>(options.threads));
    {
        std::vector<std::jthread> threads;
        for (std::size_t k = 0; k < found.size(); ++k)
            threads.emplace_back([&, k] {
                found[k] = improve(model, first, options.seed + k, moves,
                                   shared(progress, one_at_a_time, k == 0), visits);
            });
    }
    std::vector<double> lengths;
    std::uint64_t used = 0;
    bool stopped = false;
    for (const Searched& s : found) {
        lengths.push_back(length_of(*model.problem, steps_of(model, s.order)));
        used += s.moves;
        stopped = stopped || s.stopped;
    }
    Searched best =
        std::move(found[static_cast<std::size_t>(std::ranges::min_element(lengths) - lengths.begin())]);
    best.moves = used;
    best.stopped = stopped;
    return best;
}

/// Within the rules, whatever the options say of neighbours.
Outcome<Tour> solve_as_given(const Problem& problem, const Options& options, const Progress& progress) {
    const auto model = build_model(problem);
    if (!model) return tl::unexpected(model.error());
    const bool searches = options.method == Method::best || options.method == Method::exact;
    // Without rules the search begins with an order of its own.
    const auto first = searches && !model->rules.any    ? std::vector<Visit>{}
                       : options.method == Method::file ? file_order(*model)
                                                        : first_order(*model);
    if (!first) return tl::unexpected(first.error());

    Tour tour;
    const auto state = [&](const std::vector<Visit>& order) {
        tour.steps = steps_of(*model, in_first_sense(*model, order));
        tour.length = length_of(problem, tour.steps);
    };
    if (!searches) {
        tour.steps = steps_of(*model, *first);
        tour.length = length_of(problem, tour.steps);
        return tour;
    }
    const int pieces = model->piece_count();
    const bool small = pieces <= most_exact_pieces, exact = options.method == Method::exact;
    if (exact && !small)
        return fail("method exact",
                    fmt::format("there are {} elements and chains; a proof is tried up to {}", pieces,
                                most_exact_pieces),
                    "use the method best");
    // A small problem is proven from a short search: most often that leaves nothing to search for.
    const std::uint64_t moves = options.moves > 0 ? options.moves : default_moves(pieces);
    const std::uint64_t before_proof =
        small ? std::min(moves, moves_before_proof * static_cast<std::uint64_t>(std::max(pieces, 1))) : moves;
    Progress short_search = progress;
    if (small) short_search.time_used = {};
    Searched searched = improved(*model, *first, options, before_proof, short_search);
    tour.moves = searched.moves;
    tour.stopped = searched.stopped || (!small && progress.time_used);
    state(searched.order);
    if (!small || tour.stopped) return tour;
    if (const auto proven =
            prove(*model, searched.order, tour.length, exact ? patient_work : exact_work, progress)) {
        tour.proven_optimal = true;
        state(*proven);
    } else if (exact && !progress.stopped()) {
        return fail("method exact", fmt::format("no proof was found for {} elements and chains", pieces),
                    "use the method best");
    } else if (moves > before_proof || progress.time_used) {
        Options again = options;
        again.seed += 1;
        searched = improved(*model, searched.order, again, moves - before_proof, progress);
        tour.moves += searched.moves;
        tour.stopped = searched.stopped || progress.time_used;
        state(searched.order);
    }
    return tour;
}

}  // namespace

std::optional<Method> method_named(std::string_view name) {
    if (name == "best") return Method::best;
    if (name == "exact") return Method::exact;
    if (name == "nearest") return Method::nearest;
    if (name == "file") return Method::file;
    return std::nullopt;
}

Outcome<Tour> solve(const Problem& problem, const Options& options, const Progress& progress) {
    if (!options.grouped) return solve_as_given(problem, options, progress);
    std::size_t grouped = 0;
    for (const auto& group : problem.groups) grouped += group.size();
    if (grouped > 0 && (grouped < problem.elements.size() || !problem.keep_group_order))
        return fail("order grouped", "the problem has groups of its own, not of all elements or in any order",
                    "drop one of the two");
    auto tour = solve_as_given(problem, options, progress);
    if (!tour || problem.elements.empty()) return tour;
    Problem parted = problem;
    parted.groups = neighbours(problem, tour->steps);
    // Part by part, each as the tour meets its elements: that keeps all rules.
    std::vector<Step> step_of(problem.elements.size()), parts;
    for (const Step& step : tour->steps) step_of[static_cast<std::size_t>(step.element)] = step;
    for (const auto& part : parted.groups)
        for (const int e : part) parts.push_back(step_of[static_cast<std::size_t>(e)]);
    tour->steps = improve_groups(parted, std::move(parts), options.seed, progress);
    tour->ungrouped = tour->length;
    tour->length = length_of(problem, tour->steps);
    tour->groups = std::move(parted.groups);
    tour->proven_optimal = false;
    return tour;
}

}  // namespace strandline::tour
