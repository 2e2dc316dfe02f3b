// `strandline tour`: order and entries of one instance.
#include <fmt/core.h>

#include <ctime>

#include "base/units/units.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "result/stages/stages.hpp"

namespace strandline::cli {
namespace {

/// s of processor time that this program has used.
double cpu_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void print_figures(const tour::Tour& tour, const TourArguments& arguments, const Common& common) {
    if (common.json) {
        // The solution may be on its way to stdout: figures go where it does not.
        std::FILE* where = arguments.output == "-" ? stderr : stdout;
        fmt::print(where,
                   "{{\"length\": {}, \"elements\": {}, \"proven_optimal\": {}, \"moves\": {}, \"seed\": {}, "
                   "\"reproducible\": {}, \"cpu_seconds\": {:.3f}}}\n",
                   number_text(tour.length), tour.steps.size(), tour.proven_optimal, tour.moves,
                   arguments.seed, !tour.stopped, cpu_time());
    } else if (!common.quiet) {
        fmt::print(stderr, "rake up {:.3f}{}, {} elements, {} moves{}\n", tour.length,
                   tour.proven_optimal ? " (proven optimal)" : "", tour.steps.size(), tour.moves,
                   tour.stopped ? ", stopped: another run may differ" : "");
    }
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
    const auto text = read_input(arguments.input);
    if (!text) return complain(text.error(), bad_input);
    const auto instance = stages::read_instance(*text, arguments.input == "-" ? "stdin" : arguments.input);
    if (!instance) return complain(instance.error(), bad_input);
    warn(instance->warnings, common.quiet);

    tour::Options options{.seed = arguments.seed, .moves = arguments.moves};
    Progress progress = console_progress(common.quiet);
    if (limit > 0) {
        progress.time_used = [limit] { return cpu_time() / limit; };
        progress.stopped = [limit, interrupted = progress.stopped] {
            return interrupted() || cpu_time() >= limit;
        };
    }
    const auto tour = tour::solve(instance->problem, options, progress);
    if (!tour) return complain(tour.error(), bad_input);
    if (const auto written = write_output(arguments.output, stages::write_solution(*tour)); !written)
        return complain(written.error(), bad_input);
    print_figures(*tour, arguments, common);
    return done;
}

}  // namespace strandline::cli
