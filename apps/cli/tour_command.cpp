// `strandline tour`: order and entries of one instance.
#include <fmt/core.h>

#include <ctime>
#include <optional>

#include "base/text/text.hpp"
#include "base/units/units.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "result/stages/stages.hpp"

namespace strandline::cli {
namespace {

/// s of processor time that this program has used.
double cpu_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void print_figures(const tour::Tour& tour, const std::optional<tour::Entries>& entries,
                   const TourArguments& arguments, const Common& common) {
    if (common.json) {
        // The solution may be on its way to stdout: figures go where it does not.
        std::FILE* where = arguments.output == "-" ? stderr : stdout;
        fmt::print(where,
                   "{{\"length\": {}, \"elements\": {}, \"proven_optimal\": {}, \"moves\": {}, \"seed\": {}, "
                   "\"reproducible\": {}, {}\"cpu_seconds\": {:.3f}}}\n",
                   number_text(tour.length), tour.steps.size(), tour.proven_optimal, tour.moves,
                   arguments.seed, !tour.stopped,
                   entries ? fmt::format("\"length_on_edges\": {}, ", number_text(entries->length)) : "",
                   cpu_time());
    } else if (!common.quiet) {
        fmt::print(stderr, "rake up {:.3f}{}, {}, {}{}\n", tour.length,
                   tour.proven_optimal ? " (proven optimal)" : "", counted(tour.steps.size(), "element"),
                   counted(tour.moves, "move"), tour.stopped ? ", stopped: another run may differ" : "");
        if (entries)
            fmt::print(stderr, "with entries on edges {:.3f} ({:.2f} % shorter)\n", entries->length,
                       tour.length > 0 ? 100 * (1 - entries->length / tour.length) : 0);
        if (!tour.groups.empty())
            fmt::print(stderr, "in {} of neighbours: {:.3f} longer than without ({:.1f} %)\n",
                       counted(tour.groups.size(), "group"), tour.length - tour.ungrouped,
                       tour.ungrouped > 0 ? 100 * (tour.length / tour.ungrouped - 1) : 0);
    }
}

/// What another solver found, recounted.
Outcome<tour::Tour> read_tour(const std::string& file, const tour::Problem& problem) {
    const auto text = read_input(file);
    if (!text) return tl::unexpected(text.error());
    auto steps = stages::read_tsplib_tour(*text, file, problem);
    if (!steps) return tl::unexpected(steps.error());
    const auto length = tour::recount(problem, *steps);
    if (!length) return tl::unexpected(length.error());
    tour::Tour tour;
    tour.steps = std::move(*steps);
    tour.length = *length;
    return tour;
}

}  // namespace

int tour(const TourArguments& arguments, const Common& common) {
    double limit = 0;
    if (!arguments.time_limit.empty()) {
        const auto duration = parse_duration(arguments.time_limit, "--time-limit");
        if (!duration) return complain(duration.error(), bad_call);
        if (!(*duration > 0))
            return complain({"--time-limit", "is not above 0", "write a duration such as 10s"}, bad_call);
        limit = *duration;
    }
    if (arguments.method == "exact" && arguments.order == "grouped")
        return complain({"--method exact", "proves the shortest tour, which --order grouped leaves",
                         "leave one of them out"},
                        bad_call);
    if (!arguments.write_tsplib.empty() && !arguments.read_tour.empty())
        return complain(
            {"--write-tsplib", "asks for a problem, --read-tour for a solution", "leave one of them out"},
            bad_call);
    const auto text = read_input(arguments.input);
    if (!text) return complain(text.error(), bad_input);
    const auto instance = stages::read_instance(*text, arguments.input == "-" ? "stdin" : arguments.input);
    if (!instance) return complain(instance.error(), bad_input);
    warn(instance->warnings, common.quiet);

    if (!arguments.write_tsplib.empty()) {
        const auto written = stages::write_tsplib(instance->problem);
        if (!written) return complain(written.error(), bad_input);
        if (const auto out = write_output(arguments.write_tsplib, *written); !out)
            return complain(out.error(), bad_input);
        return done;
    }

    const tour::Options options{.method = *tour::method_named(arguments.method),
                                .grouped = arguments.order == "grouped",
                                .threads = arguments.threads,
                                .seed = arguments.seed,
                                .moves = arguments.moves};
    Progress progress = console_progress(common.quiet);
    if (limit > 0) {
        const double total = limit * arguments.threads;
        progress.time_used = [total] { return cpu_time() / total; };
        progress.stopped = [total, interrupted = progress.stopped] {
            return interrupted() || cpu_time() >= total;
        };
    }
    const auto tour = arguments.read_tour.empty() ? tour::solve(instance->problem, options, progress)
                                                  : read_tour(arguments.read_tour, instance->problem);
    if (!tour) return complain(tour.error(), bad_input);
    std::optional<tour::Entries> entries;
    if (arguments.entries == "edges") entries = tour::entered_on_edges(instance->problem, tour->steps);
    const std::string solution = stages::write_solution(*tour, instance->problem, entries);
    if (const auto written = write_output(arguments.output, solution); !written)
        return complain(written.error(), bad_input);
    print_figures(*tour, entries, arguments, common);
    return done;
}

}  // namespace strandline::cli
