#include "plan/pipeline/shortfalls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/text.hpp"
#include "plan/pipeline/hints.hpp"
#include "plan/pipeline/surroundings.hpp"

namespace strandline::pipeline {
namespace {

void say_undrivable(Plan& plan) {
    if (plan.undrivable.empty()) return;
    double sum = 0;
    for (const Spot& spot : plan.undrivable) sum += spot.amount;
    const Spot& longest = *std::ranges::max_element(plan.undrivable, {}, &Spot::amount);
    plan.warnings.push_back(
        {"the drive",
         fmt::format("the rake cannot follow its path along {}, {:.2f} m together, the longest {:.2f} m near "
                     "({:.2f}, {:.2f}): it is lifted there in areas and beside its place on lines",
                     counted(plan.undrivable.size(), "span"), sum, longest.amount, longest.at.x,
                     longest.at.y)});
}

void say_blemishes(Plan& plan) {
    int places = 0;
    double sum = 0;
    const Spot* longest = nullptr;
    for (const Spot& spot : plan.blemishes) {
        if (!spot.what.starts_with("no way")) continue;
        ++places;
        sum += spot.amount;
        if (longest == nullptr || spot.amount > longest->amount) longest = &spot;
    }
    if (longest == nullptr) return;
    plan.warnings.push_back(
        {"avoid.finished",
         fmt::format(
             "at {} no way round finished areas was found: {:.2f} m are driven nearer to them than "
             "{:.2f} m (avoid.clearance), the longest {:.2f} m near ({:.2f}, {:.2f}); check says how much of "
             "it goes over them",
             counted(places, "place"), sum, clearance_of(plan.options, plan.robot), longest->amount,
             longest->at.x, longest->at.y)});
}

bool in_one_stroke(const Plan& plan, int stroke) {
    if (stroke < 0) return false;
    const int element = plan.strokes[static_cast<std::size_t>(stroke)].element;
    const Element& of = plan.drawing.elements[static_cast<std::size_t>(element)];
    return is_region(of) && options_for(of, plan.options).fill.one_stroke;
}

/// Loops at corners, and where the rake is lost, between two draws of the same stroke; turns on the spot are
/// none.
void say_lifts(Plan& plan) {
    constexpr double rounding = 1e-5;  // metres, of a turn on the spot
    int lifts = 0, drawn = -1;
    double up = 0;  // metres since the last draw
    Point last, first;
    for (std::size_t i = 0; i < plan.samples.size(); ++i) {
        const Sample& sample = plan.samples[i];
        if (i > 0 && plan.samples[i - 1].motion != Motion::draw)
            up += distance(plan.samples[i - 1].pose.at, sample.pose.at);
        if (sample.motion != Motion::draw) continue;
        if (up > rounding && sample.stroke == drawn && in_one_stroke(plan, drawn) && ++lifts == 1)
            first = last;
        up = 0;
        drawn = sample.stroke;
        last = sample.rake;
    }
    if (lifts == 0) return;
    ++plan.figures.fallbacks;
    plan.warnings.push_back(
        {"fill.one_stroke",
         fmt::format("the rake is lifted all the same {} within areas, where {} cannot follow "
                     "a corner with the rake down, first near ({:.2f}, {:.2f})",
                     counted(lifts, "time"), plan.robot.name, first.x, first.y)});
}

void say_marks(Plan& plan) {
    if (plan.robot.lifts || plan.strokes.size() < 2) return;
    plan.warnings.push_back(
        {"robot.lifts", fmt::format("the tool of {} cannot be lifted: what is driven between strokes, "
                                    "{:.2f} m, is marked too",
                                    plan.robot.name, plan.figures.up_driven)});
}

/// A rake at the turning point cannot be driven beside its path (steered()).
void say_beside(Plan& plan) {
    if (plan.robot.rake_offset > 0) return;
    int beside = 0;
    double off = 0;
    for (const Stroke& stroke : plan.strokes) {
        const double here = std::abs(middle_of(plan.robot, pin_mask(plan.robot, stroke.pins)));
        if (here == 0) continue;
        ++beside;
        off = here;
    }
    if (beside == 0) return;
    plan.warnings.push_back(
        {"robot.rake_offset",
         fmt::format("{} strokes lie {:g} m beside their lines: their pins are not in the rake's middle, and "
                     "with the rake at the turning point the robot cannot drive beside its path; draw them "
                     "with {} number of pins",
                     beside, off, plan.robot.pins % 2 == 0 ? "an even" : "an odd")});
}

}  // namespace

void say_shortfalls(Plan& plan) {
    say_marks(plan);
    say_undrivable(plan);
    say_beside(plan);
    say_blemishes(plan);
    say_lifts(plan);
}

}  // namespace strandline::pipeline
