// `strandline fill POLYGON.json`: one polygon to strokes.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "arguments.hpp"
#include "base/units/units.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "result/stages/stages.hpp"

namespace strandline::cli {
namespace {

constexpr double width_per_tolerance = 200;  // less than that no sand shows

Outcome<double> positive(const std::string& text, const std::string& option) {
    auto value = parse_length(text, option);
    if (value && !(*value > 0)) return fail(option, "must be above 0");
    return value;
}

/// Sets a field to the choice of that name; the exit code if there is none.
template <class Choice>
std::optional<int> choose(Choice& field, const std::string& name, const char* option) {
    const auto choice = fill::named<Choice>(name, option);
    if (!choice) return complain(choice.error(), bad_call);
    field = *choice;
    return {};
}

/// Gaps beyond these are only counted, unless -v asks for all.
constexpr std::size_t most_gaps_named = 3;

void print_account(const rake::Account& account, std::size_t strokes, const FillArguments& arguments,
                   const Common& common) {
    if (common.json) {
        // The strokes may be on their way to stdout: figures go where they do not.
        fmt::print(arguments.output == "-" ? stderr : stdout, "{}", stages::write_account(account));
        return;
    }
    fmt::print(
        stderr,
        "{:.2f} % raked, {:.2f} % twice, {:.2f} % outside; raked length x width / area = {:.3f}\n"
        "{} strokes, {} rake-up moves over a width, {} shorter; {} drives over finished sand ({:.3g})\n",
        100 * account.coverage, 100 * account.overdraw, 100 * account.spill, account.ratio, strokes,
        account.hops, account.pivots, account.drives_over, account.driven_over);
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
    fill::Options options;
    if (const auto wrong = choose(options.style, arguments.style, "--style")) return *wrong;
    if (const auto wrong = choose(options.join, arguments.join, "--join")) return *wrong;
    if (const auto wrong = choose(options.narrow, arguments.narrow, "--narrow")) return *wrong;
    if (const auto wrong = choose(options.insets, arguments.inset, "--inset")) return *wrong;
    if (const auto wrong = choose(options.partition, arguments.partition, "--partition")) return *wrong;
    options.shift = arguments.shift;

    std::optional<double> width, spacing;
    if (!arguments.width.empty()) {
        const auto value = positive(arguments.width, "--width");
        if (!value) return complain(value.error(), bad_call);
        width = *value;
    }
    if (!arguments.spacing.empty()) {
        const auto value = positive(arguments.spacing, "--spacing");
        if (!value) return complain(value.error(), bad_call);
        spacing = *value;
    }
    if (!arguments.direction.empty()) {
        const auto value = parse_angle(arguments.direction, "--direction");
        if (!value) return complain(value.error(), bad_call);
        options.direction = *value;
    }
    auto cuts = fill::cuts_of(arguments.cuts, "--cuts");
    if (!cuts) return complain(cuts.error(), bad_call);
    options.cuts = std::move(*cuts);
    auto segments = fill::segment_choices_of(arguments.segments, "--segments");
    if (!segments) return complain(segments.error(), bad_call);
    options.segments = std::move(*segments);
    options.one_stroke = arguments.one_stroke;
    Warnings unused;
    for (const fill::Choice& choice : fill::choices_of(options))
        if (!choice.read)
            unused.push_back(
                {fmt::format("--{}", choice.name),
                 fmt::format("does nothing with --style {}: it serves {}", arguments.style, choice.serves)});
    if (arguments.vehicle != "free") {
        const auto robot = robot_named(arguments.vehicle);
        if (!robot) return complain(robot.error(), bad_call);
        // The rake's own path may turn as tightly as the offset allows; a machine without an offset turns on
        // the spot.
        options.turn_radius =
            robot->min_radius > 0 ? 1.1 * std::hypot(robot->rake_offset, robot->rake_side) : 0;
        options.pins = robot->pins;
    } else {
        options.rake_turns = false;  // may lift, pivot and back up for nothing
        options.pivots = true;
    }

    const auto text = read_input(arguments.input);
    if (!text) return complain(text.error(), bad_input);
    const auto task = stages::read_polygon(*text, arguments.input);
    if (!task) return complain(task.error(), bad_input);
    warn(task->warnings, common.quiet);
    if (!width) width = task->width;
    if (!width)
        return complain(
            {arguments.input, "has no width, and the call neither", "give the rake's width by --width"},
            bad_call);
    options.width = *width;
    if (arguments.pins) options.pins = *arguments.pins;
    // Neighbouring passes share a pin, which the second one lifts: sand beside a bend is still reached.
    const bool shared = arguments.pins && *arguments.pins > 1;
    options.masked = shared;
    options.spacing = spacing.value_or(shared ? *width * (*arguments.pins - 1) / *arguments.pins : *width);
    if (options.spacing > options.width)
        return complain({"--spacing", "is wider than the rake", fmt::format("at most {}", *width)}, bad_call);
    options.min_area = 0;  // the file names the one area it wants filled
    options.tolerance = options.width / width_per_tolerance;

    const Progress progress = console_progress(common.quiet);
    std::vector<bool> cuts_used(options.cuts.size()), segments_used(options.segments.size());
    std::vector<Stroke> strokes;
    std::vector<Polyline> ways;
    for (std::size_t i = 0; i < task->regions.size(); ++i) {
        progress.report("filling", static_cast<double>(i) / static_cast<double>(task->regions.size()));
        const std::string place =
            task->regions.size() == 1 ? arguments.input : fmt::format("{}, part {}", arguments.input, i + 1);
        fill::Fill filled = fill::fill_region(task->regions[i], 0, place, options);
        warn(filled.warnings, common.quiet);
        for (std::size_t k = 0; k < cuts_used.size(); ++k)
            if (filled.cuts_used[k]) cuts_used[k] = true;
        for (std::size_t k = 0; k < segments_used.size(); ++k)
            if (filled.segments_used[k]) segments_used[k] = true;
        strokes.insert(strokes.end(), filled.strokes.begin(), filled.strokes.end());
        ways.insert(ways.end(), filled.ways.begin(), filled.ways.end());
    }
    progress.report("filling", 1);
    if (options.style == fill::Style::zigzag) {
        for (std::size_t i = 0; i < cuts_used.size(); ++i)
            if (!cuts_used[i])
                unused.push_back(
                    {"--cuts", fmt::format("cut {} parts nothing: draw it from edge to edge", i + 1)});
        for (std::size_t i = 0; i < segments_used.size(); ++i)
            if (!segments_used[i])
                unused.push_back(
                    {"--segments",
                     fmt::format("choice {} lies in no segment: name a point inside of one", i + 1)});
    }
    warn(unused, common.quiet);
    if (strokes.empty())
        return complain({arguments.input, "nothing of it can be raked", "use a narrower rake"}, bad_input);
    std::vector<rake::PinSpans> masks;
    if (arguments.pins)
        masks =
            rake::pin_masks(task->regions, strokes, ways,
                            {.width = options.width, .pins = options.pins, .tolerance = options.tolerance});
    const std::vector<rake::Move> moves =
        rake::moves_of(strokes, ways, masks, options.pins, options.tolerance);
    const auto written =
        write_output(arguments.output, stages::write_moves(*task, *width, moves, arguments.pins));
    if (!written) return complain(written.error(), bad_input);
    if (common.json || !common.quiet) {
        const rake::Account account =
            rake::account_of(task->regions, moves, {.width = options.width, .pins = options.pins});
        print_account(account, strokes.size(), arguments, common);
    }
    return done;
}

}  // namespace strandline::cli
