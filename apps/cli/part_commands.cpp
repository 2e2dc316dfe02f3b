// Commands that cut a plan: resume and split.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "base/text/text.hpp"
#include "base/units/units.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "part_plans.hpp"
#include "plan/parts/parts.hpp"
#include "result/formats/formats.hpp"
#include "summary.hpp"

namespace strandline::cli {
namespace {

Outcome<Plan> read_driven_plan(const std::string& path) {
    const auto text = read_input(path);
    if (!text) return tl::unexpected(text.error());
    auto plan = formats::read_plan(*text, path);
    if (!plan) return plan;
    if (auto can = parts::can_be_cut(*plan); !can) {
        can.error().place = path;
        return tl::unexpected(can.error());
    }
    return plan;
}

/// "3.5,2" is a place, "12min" or "90" a time, all else an element.
Outcome<parts::From> read_from(const std::string& text) {
    if (const std::size_t comma = text.find(','); comma != std::string::npos) {
        const auto x = parse_length(text.substr(0, comma), "--from"),
                   y = parse_length(text.substr(comma + 1), "--from");
        if (x && y) return parts::From(Point{*x, *y});
    }
    if (const auto time = parse_duration(text, "--from"); time && *time >= 0) return parts::From(*time);
    return parts::From(text);
}

std::string drawn_text(const Plan& plan) {
    return fmt::format("{}, {:.1f} m drawn, {}", counted(plan.strokes.size(), "stroke"), plan.figures.drawn,
                       duration(plan.figures.time));
}

}  // namespace

Outcome<parts::Limit> read_limit(const std::string& text, const std::string& place) {
    parts::Limit limit;
    if (const auto time = parse_duration(text, place);
        time && text.find_first_of("smh") != std::string::npos && !text.ends_with("m")) {
        limit.seconds = *time;
    } else if (const auto metres = parse_length(text, place); metres && text.ends_with("m")) {
        limit.metres = *metres;
    }
    if (!(limit.seconds > 0 || limit.metres > 0))
        return fail(place + " " + text, "is neither a time nor a length", "write for example 30min or 200m");
    return limit;
}

Outcome<void> write_parts(const Plan& plan, const parts::Limit& limit, const std::string& output,
                          bool quiet) {
    const std::string base = output.ends_with(".json") ? output.substr(0, output.size() - 5) : output;
    const std::vector<int> begins = parts::cuts(plan, limit);
    std::vector<std::string> texts;
    std::vector<std::pair<std::string, std::string_view>> files;
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const int end = k + 1 < begins.size() ? begins[k + 1] : static_cast<int>(plan.strokes.size());
        const Plan part = parts::part(plan, begins[k], end);
        const std::string name = fmt::format("{}-{}.json", base, k + 1);
        if (!quiet) fmt::print(stderr, "{}: {}\n", name, drawn_text(part));
        if (!quiet)
            for (const Warning& warning : part.warnings)
                if (std::ranges::find(plan.warnings, warning) == plan.warnings.end())
                    fmt::print(stderr, "warning: {}\n", sentence(warning));
        texts.push_back(formats::write_plan(part));
        files.emplace_back(name, "");
    }
    for (std::size_t k = 0; k < files.size(); ++k) files[k].second = texts[k];
    return write_outputs(files);
}

int resume(const ResumeArguments& arguments, const Common& common) {
    const auto plan = read_driven_plan(arguments.input);
    if (!plan) return complain(plan.error(), bad_input);
    const auto from = read_from(arguments.from);
    if (!from) return complain(from.error(), bad_call);
    const auto first = parts::stroke_at(*plan, *from);
    if (!first) return complain(first.error(), bad_call);
    const Plan rest = parts::part(*plan, *first, static_cast<int>(plan->strokes.size()));
    if (!common.quiet)
        fmt::print(
            stderr, "from stroke {} of {}, the robot at ({:.2f}, {:.2f}), heading {:.0f} degrees: {}\n",
            *first, plan->strokes.size(), rest.samples.front().pose.at.x, rest.samples.front().pose.at.y,
            rest.samples.front().pose.heading * 180 / pi, drawn_text(rest));
    const auto written = write_output(arguments.output, formats::write_plan(rest));
    if (!written) return complain(written.error(), bad_input);
    return done;
}

int split(const SplitArguments& arguments, const Common& common) {
    const auto limit = read_limit(arguments.every, "--every");
    if (!limit) return complain(limit.error(), bad_call);
    const auto plan = read_driven_plan(arguments.input);
    if (!plan) return complain(plan.error(), bad_input);
    const auto written = write_parts(*plan, *limit, arguments.output, common.quiet);
    if (!written) return complain(written.error(), bad_input);
    return done;
}

}  // namespace strandline::cli
