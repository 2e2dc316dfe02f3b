#include "result/sketch/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strandline::sketch {
namespace {

// Proportions of the picture, in letter sizes (em).
constexpr double view_ems = 64;      // the picture's width: the legend's one row fits
constexpr double pad = 1.2;          // free round everything
constexpr double arrow_spacing = 9;  // between arrows of one trip
constexpr double arrow_least = 1.6;  // a shorter trip has no room for an arrow
constexpr double sign_width = 2.4, gap = 0.6, between_items = 1.8;
constexpr double letter_advance =
    0.52;  // mean width of a sans-serif letter: the layout must not depend on a font

std::vector<Groove> grooves_of(const Robot& robot, const Run& run) {
    std::vector<Groove> grooves;
    const int pins = std::clamp(robot.pins, 0, 32);
    const auto down = [&](int pin) { return pin < pins && ((run.mask >> (pins - 1 - pin)) & 1U); };
    for (int pin = 0; pin < pins; ++pin) {  // 0: the leftmost
        if (!down(pin)) continue;
        const int first = pin;
        while (down(pin + 1)) ++pin;
        const double middle = (pins - 1) / 2.0 - (first + pin) / 2.0;
        grooves.push_back(
            {run, middle * robot.pin_pitch, pin - first + 1, groove_width(robot, pin - first + 1)});
    }
    return grooves;
}

std::vector<Pose> arrows_on(const Polyline& track, double em) {
    const double all = length(track);
    std::vector<Pose> arrows;
    if (all < arrow_least * em) return arrows;
    const double count = std::max(1.0, std::floor(all / (arrow_spacing * em)));
    double walked = 0, next = all / (2 * count);
    for (std::size_t i = 1; i < track.size(); ++i) {
        const double step = distance(track[i - 1], track[i]);
        for (; step > 0 && walked + step >= next && arrows.size() < static_cast<std::size_t>(count);
             next += all / count)
            arrows.push_back(
                {between(track[i - 1], track[i], (next - walked) / step), heading(track[i] - track[i - 1])});
        walked += step;
    }
    return arrows;
}

Box intersection(Box a, Box b) {
    return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
            {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

std::string metres_text(double metres) { return fmt::format("{:.{}f} m", metres, metres < 10 ? 2 : 1); }

std::string time_text(double seconds) {
    if (seconds < 120) return fmt::format("{:.0f} s", seconds);
    const double minutes = std::round(seconds / 60);
    if (minutes < 120) return fmt::format("{:.0f} min", minutes);
    return fmt::format("{:.0f} h {:02.0f} min", std::floor(minutes / 60), std::fmod(minutes, 60));
}

/// The largest of 1, 2, 5 x 10^n metres that is at most `most`.
double rule_length(double most) {
    const double decade = std::pow(10, std::floor(std::log10(most)));
    for (const double step : {5.0, 2.0})
        if (step * decade <= most) return step * decade;
    return decade;
}

/// A title that leaves room for the figures beside it; cut between UTF-8 characters.
std::string shortened(std::string title) {
    constexpr std::size_t most = 30;
    if (title.size() <= most) return title;
    std::size_t cut = most - 1;
    while (cut > 0 && (static_cast<unsigned char>(title[cut]) & 0xC0U) == 0x80U) --cut;
    return title.substr(0, cut) + "…";
}

/// Rows under everything drawn: title and figures, then the signs.
void lay_legend(Sketch& sketch, const Plan& plan) {
    const double em = sketch.em;
    const Figures& figures = plan.figures;
    sketch.title = shortened(plan.title);
    sketch.caption =
        fmt::format("{:.4g} × {:.4g} m · {} drawn · {} rake up · {}", plan.drawing.canvas.width,
                    plan.drawing.canvas.height, metres_text(figures.drawn),
                    metres_text(figures.up_driven + figures.loops_driven), time_text(figures.time));
    const double left = sketch.view.low.x + pad * em;
    double y = sketch.view.low.y - 0.9 * em;
    sketch.title_at = {left, y};
    const double title_width = sketch.title.empty() ? 0 : (sketch.title.size() * 0.62 + 1.6) * em;
    sketch.caption_at = {left + title_width, y};
    y -= 2 * em;
    const double rule = rule_length(sketch.view.width() / 7);
    double x = left;
    const auto add = [&](LegendItem::Sign sign, double width, std::string text) {
        const double advance = static_cast<double>(text.size()) * letter_advance * em;
        sketch.legend.push_back(
            {sign, {x, y}, {x + width + gap * em, y - 0.34 * em}, width, std::move(text)});
        x += width + (gap + between_items) * em + advance;
    };
    using Sign = LegendItem::Sign;
    add(Sign::groove, sign_width * em, "rake down, true width");
    add(Sign::trip, sign_width * em, "rake up, track of the rake");
    add(Sign::start, 0.9 * em, "start");
    add(Sign::end, 0.9 * em, "end");
    add(Sign::rule, rule, fmt::format("{} m", rule));
    if (!sketch.keep_outs.empty() || !sketch.border.empty()) {  // a row of their own
        x = left;
        y -= 1.7 * em;
    }
    if (!sketch.keep_outs.empty()) add(Sign::keep_out, sign_width * em, "keep-out");
    if (!sketch.border.empty()) add(Sign::border, sign_width * em, "field");
    sketch.view.low.y = y - (0.6 + pad) * em;
}

}  // namespace

bool drawable(const Sketch& sketch) {
    return sketch.em > 0 && std::isfinite(sketch.view.width()) && std::isfinite(sketch.view.height());
}

std::vector<Run> runs(const std::vector<Sample>& samples) {
    std::vector<Run> list;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const Sample& sample = samples[i];
        const bool draws = sample.motion == Motion::draw;
        const Run step{i, i + 1, sample.mask, draws || sample.mask != 0 ? sample.stroke : -1, draws};
        if (!list.empty() && list.back().mask == step.mask && list.back().stroke == step.stroke &&
            list.back().draws == draws)
            list.back().last = step.last;
        else
            list.push_back(step);
    }
    return list;
}

Polyline bar_track(const std::vector<Sample>& samples, const Run& run, double offset) {
    Polyline track;
    track.reserve(run.last - run.first + 1);
    for (std::size_t i = run.first; i <= run.last; ++i)
        if (const Point p = samples[i].rake + offset * left_normal(unit(samples[i].pose.heading));
            is_finite(p))
            track.push_back(p);
    return track;
}

Polygon arrow_head(Pose pose, double size) {
    const Point ahead = size * unit(pose.heading), left = left_normal(ahead);
    return {pose.at + 0.5 * ahead, pose.at - 0.5 * ahead + 0.36 * left, pose.at - 0.28 * ahead,
            pose.at - 0.5 * ahead - 0.36 * left};
}

Sketch sketched(const Plan& plan, const Options& options) {
    Sketch sketch;
    sketch.canvas = {{0, 0}, {plan.drawing.canvas.width, plan.drawing.canvas.height}};
    Box drawn = sketch.canvas;
    const double reach = plan.robot.rake_width() / 2;
    for (const Sample& sample : plan.samples)
        drawn = united(
            drawn, sample.mask ? grown({sample.rake, sample.rake}, reach) : Box{sample.rake, sample.rake});
    const DriveArea area = drive_area_of(plan);
    sketch.keep_outs = area.keep_out;
    if (plan.drawing.border || !plan.options.field.border.empty()) sketch.border = area.border.outer;
    // One that is somewhere else altogether stays out of the picture.
    const Box near = grown(drawn, std::max(drawn.width(), drawn.height()) / 4);
    for (const Region& keep_out : area.keep_out)
        if (overlaps(bounds(keep_out), near)) drawn = united(drawn, intersection(bounds(keep_out), near));
    if (!sketch.border.empty()) drawn = united(drawn, intersection(bounds(sketch.border), near));
    sketch.em = drawn.width() / (view_ems - 2 * pad);
    sketch.view = grown(drawn, pad * sketch.em);
    if (!drawable(sketch)) return sketch;
    for (const Run& run : runs(plan.samples)) {
        if (run.mask != 0) {
            const auto grooves = grooves_of(plan.robot, run);
            sketch.grooves.insert(sketch.grooves.end(), grooves.begin(), grooves.end());
            continue;
        }
        Trip trip{run, bar_track(plan.samples, run, 0), {}};
        if (options.arrows) trip.arrows = arrows_on(trip.track, sketch.em);
        sketch.trips.push_back(std::move(trip));
    }
    sketch.driven = !plan.samples.empty();
    if (sketch.driven) {
        sketch.start = {plan.samples.front().rake, plan.samples.front().pose.heading};
        sketch.end = plan.samples.back().rake;
    }
    if (options.legend) lay_legend(sketch, plan);
    return sketch;
}

}  // namespace strandline::sketch
