#include "planning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/units/units.hpp"
#include "console.hpp"
#include "plan/pipeline/pipeline.hpp"

namespace strandline::cli {
namespace {

/// A plan with these options. What tour.time_limit allows is this plan's own.
using Attempt = std::function<Outcome<Plan>(const Options&)>;

/// The largest drawing whose drive takes at most `most` seconds: the width is halved between one that fits
/// and one that does not. A plan is made for each; time grows with the width, nearly always. `stopped`: the
/// user wants the best so far.
Outcome<Plan> planned_within(double most, Options options, const Attempt& attempt,
                             const std::function<bool()>& stopped) {
    auto whole = attempt(options);
    if (!whole || whole->figures.time <= most) return whole;
    Box box;
    for (const Element& element : whole->drawing.elements) box = united(box, bounds(element));
    const double width = box.width();
    if (!(width > 0)) return fail("--max-time", "the drawing has no width to make smaller", "leave it out");
    constexpr int halvings = 7;
    constexpr double least = 0.02;
    double low = least, high = 1;  // shares of the width: too small or fitting, too large
    std::optional<Plan> best;
    std::string too_long, too_small;  // the smallest of those, the largest of these
    int tried = 0;
    for (; tried < halvings && !stopped(); ++tried) {
        // Time grows between linearly (lines) and with the square (areas).
        const double share =
            tried == 0 ? std::max(least, std::sqrt(most / whole->figures.time)) : std::sqrt(low * high);
        options.place.mode = "width";
        options.place.width = share * width;
        auto plan = attempt(options);
        if (plan && plan->figures.time > most) {
            high = share;
            too_long = fmt::format("even {:.2f} m wide the drive takes longer", share * width);
            continue;
        }
        low = share;
        if (plan)
            best = std::move(*plan);
        else
            too_small =
                fmt::format("{:.2f} m wide it cannot be planned ({})", share * width, sentence(plan.error()));
    }
    const bool given_up = stopped();  // also halfway through the last one
    if (!best && given_up)
        return fail("--max-time",
                    tried == 0 ? "stopped before a smaller size was tried"
                               : "stopped before a size was found that fits",
                    "let it go on, allow more time, or leave --max-time out");
    if (!best)
        return fail("--max-time",
                    too_long + (!too_long.empty() && !too_small.empty() ? ", and " : "") + too_small,
                    "allow more time, or draw less");
    if (given_up) {
        best->figures.reproducible = false;
        best->warnings.push_back({"--max-time", "stopped: a larger drawing may fit as well"});
    }
    return std::move(*best);
}

}  // namespace

Outcome<Asked> asked_of(const PlanArguments& arguments) {
    auto wishes = gathered(arguments);
    if (!wishes) return tl::unexpected(wishes.error());
    auto robot = robot_of(*wishes);
    if (!robot) return tl::unexpected(robot.error());
    if (const auto fits = valid(wishes->options, *robot); !fits) return tl::unexpected(fits.error());
    Asked asked{std::move(*wishes), std::move(*robot)};
    if (arguments.max_time.empty()) return asked;
    const auto limit = parse_duration(arguments.max_time, "--max-time");
    if (!limit) return tl::unexpected(limit.error());
    if (!(*limit > 0)) return fail("--max-time", "is not above 0", "write for example 40min");
    asked.most_time = *limit;
    return asked;
}

Outcome<Plan> planned(const svg::Document& document, const std::string& title, const Asked& asked,
                      const Progress& progress) {
    const Wishes& wishes = asked.wishes;
    const Attempt attempt = [&](const Options& options) {
        return make_plan(document, title, asked.robot, options, wishes.edits,
                         limited(progress, options.tour.time_limit, options.tour.threads));
    };
    auto plan = asked.most_time > 0
                    ? planned_within(asked.most_time, wishes.options, attempt, progress.stopped)
                    : attempt(wishes.options);
    if (!plan) return plan;
    plan->program = "strandline " STRANDLINE_VERSION;
    plan->warnings.insert(plan->warnings.begin(), wishes.warnings.begin(), wishes.warnings.end());
    return plan;
}

Error in_file(Error error, const std::string& title, const std::string& input) {
    if (error.place.empty() || error.place == title)
        error.place = input;
    else if (error.place != input)
        error.place = input + ", " + error.place;
    return error;
}

}  // namespace strandline::cli
