#include "planning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units/units.hpp"
#include "plan/pipeline/pipeline.hpp"

namespace strandline::cli {
namespace {

/// The largest drawing whose drive takes at most `most` seconds: the width is halved between one that fits
/// and one that does not. A plan is made for each; time grows with the width, nearly always.
Outcome<Plan> planned_within(double most, const svg::Document& document, const std::string& title,
                             const Robot& robot, Options options, const std::vector<Edit>& edits,
                             const Progress& progress) {
    auto whole = make_plan(document, title, robot, options, edits, progress);
    if (!whole || whole->figures.time <= most) return whole;
    Box box;
    for (const Element& element : whole->drawing.elements) box = united(box, bounds(element));
    const double width = box.width();
    if (!(width > 0)) return fail("--max-time", "the drawing has no width to make smaller", "leave it out");
    constexpr int halvings = 7;
    constexpr double least = 0.02;
    double fits = least, exceeds = 1;
    Outcome<Plan> best =
        fail("--max-time", fmt::format("even {:.2f} m wide the drive takes longer", least * width),
             "allow more time, or draw less");
    for (int k = 0; k < halvings && !progress.stopped(); ++k) {
        // Time grows between linearly (lines) and with the square (areas).
        const double share =
            k == 0 ? std::max(least, std::sqrt(most / whole->figures.time)) : std::sqrt(fits * exceeds);
        options.place.mode = "width";
        options.place.width = share * width;
        auto plan = make_plan(document, title, robot, options, edits, progress);
        if (plan && plan->figures.time <= most) {
            fits = share;
            best = std::move(plan);
        } else {
            exceeds = share;
        }
    }
    return best;
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
    auto plan = asked.most_time > 0
                    ? planned_within(asked.most_time, document, title, asked.robot, wishes.options,
                                     wishes.edits, progress)
                    : make_plan(document, title, asked.robot, wishes.options, wishes.edits, progress);
    if (plan) plan->program = "strandline " STRANDLINE_VERSION;
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
