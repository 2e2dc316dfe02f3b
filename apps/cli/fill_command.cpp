// `strandline fill POLYGON.json`: one polygon to strokes.
#include <fmt/core.h>

#include <algorithm>
#include <span>

#include "arguments.hpp"
#include "base/text/text.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "fill_stage.hpp"
#include "result/stages/stages.hpp"

namespace strandline::cli {
namespace {

/// Gaps beyond these are only counted, unless -v asks for all.
constexpr std::size_t most_gaps_named = 3;

void print_account(const rake::Account& account, std::size_t strokes, const FillArguments& arguments,
                   const Common& common) {
    if (common.json) {
        // The strokes may be on their way to stdout: figures go where they do not.
        fmt::print(arguments.output == "-" ? stderr : stdout, "{}", stages::write_account(account));
        return;
    }
    fmt::print(stderr,
               "{:.2f} % raked, {:.2f} % twice, {:.2f} % outside; raked length x width / area = {:.3f}\n"
               "{}, {} over a width, {} shorter; {} over finished sand ({:.3g})\n",
               100 * account.coverage, 100 * account.overdraw, 100 * account.spill, account.ratio,
               counted(strokes, "stroke"), counted(account.hops, "rake-up move"), account.pivots,
               counted(account.drives_over, "drive"), account.driven_over);
    const std::size_t named =
        common.verbose ? account.gaps.size() : std::min(most_gaps_named, account.gaps.size());
    for (const rake::Gap& gap : std::span(account.gaps).first(named))
        fmt::print(stderr, "bare: {:.3g} x {:.3g} near ({:.4g}, {:.4g})\n", gap.disc, gap.area / gap.disc,
                   gap.at.x, gap.at.y);
    if (named < account.gaps.size())
        fmt::print(stderr, "bare: {} more (-v lists them)\n", account.gaps.size() - named);
}

}  // namespace

int fill(const FillArguments& arguments, const Common& common) {
    std::optional<Robot> vehicle;
    if (arguments.vehicle != "free") {
        auto robot = robot_named(arguments.vehicle);
        if (!robot) return complain(robot.error(), bad_call);
        vehicle = std::move(*robot);
    }
    auto asked = fill_asked(arguments, vehicle);
    if (!asked) return complain(asked.error(), bad_call);
    const auto text = read_input(arguments.input);
    if (!text) return complain(text.error(), bad_input);
    const auto task = stages::read_polygon(*text, arguments.input);
    if (!task) return complain(task.error(), bad_input);
    warn(task->warnings, common.quiet);
    const bool no_width = !asked->width && !task->width;
    Warnings warnings;
    const auto made =
        filled(std::move(*asked), *task, arguments.input, warnings, console_progress(common.quiet));
    warn(warnings, common.quiet);
    if (!made)
        return complain(made.error(),
                        no_width || made.error().place.starts_with("--") ? bad_call : bad_input);
    const auto written =
        write_output(arguments.output, stages::write_moves(*task, made->width, made->moves, arguments.pins));
    if (!written) return complain(written.error(), bad_input);
    if (common.json || !common.quiet)
        print_account(account_of(*made, *task), made->strokes, arguments, common);
    return done;
}

}  // namespace strandline::cli
