#include "plan/pipeline/pipeline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units/units.hpp"
#include "path/trajectory/trajectory.hpp"
#include "plan/parts/parts.hpp"
#include "plan/pipeline/edits.hpp"
#include "plan/pipeline/hints.hpp"
#include "plan/pipeline/pins.hpp"
#include "plan/pipeline/shortfalls.hpp"
#include "plan/pipeline/stages.hpp"
#include "plan/pipeline/surroundings.hpp"

namespace strandline {

Outcome<DrawingOptions> pipeline::drawing_options(const Options& options) {
    const Options::Fit& place = options.place;
    DrawingOptions o;
    o.canvas = {options.canvas.width, options.canvas.height};
    o.margin = options.canvas.margin;
    o.place = place.mode == "actual"  ? Place::actual
              : place.mode == "width" ? Place::width
              : place.mode == "scale" ? Place::scale
                                      : Place::fit;
    o.place_width = place.width;
    o.scale_denominator = place.scale_denominator;
    if (place.positioned) o.position = Point{place.x, place.y};
    o.rotate = place.rotate;
    o.mirror = place.mirror;
    o.tolerance = options.drawing.tolerance;
    o.join_tolerance = options.drawing.join_tolerance;
    o.min_length = options.drawing.min_length;
    o.min_area = options.fill.min_area;
    o.simplify = options.drawing.simplify;
    o.smooth = options.drawing.smooth;
    o.occlusion = options.drawing.occlusion;
    o.ink_threshold = options.ink.threshold;
    o.invert = options.ink.invert;
    o.layers = names_of(options.drawing.layers);
    o.tools = options.drawing.tools == "layer"    ? DrawingOptions::Tools::by_layer
              : options.drawing.tools == "colour" ? DrawingOptions::Tools::by_colour
                                                  : DrawingOptions::Tools::asked;
    auto rules = rules_of(options.drawing.rules);
    if (!rules) return tl::unexpected(rules.error());
    o.rules = std::move(*rules);
    return o;
}

order::Options pipeline::order_options(const Options& options, const Robot& robot) {
    order::Options o;
    o.tour.method = *tour::method_named(options.tour.method);
    o.tour.grouped = options.tour.grouped;
    o.tour.threads = options.tour.threads;
    o.straight = options.tour.cost == "straight";
    if (options.tour.cost == "seconds") o.slow_bends = robot.travel_speed / robot.turn_rate;
    o.tour.seed = static_cast<std::uint64_t>(options.tour.seed);
    o.tour.moves = static_cast<std::uint64_t>(options.tour.moves);
    o.drive.corner_threshold = options.corner.threshold;
    o.drive.corner_radius = options.corner.radius;
    o.drive.fill_radius = options.corner.fill_radius;
    o.drive.below = options.corner.below == "round" ? drive::Below::round : drive::Below::exact;
    o.drive.above = options.corner.above == "pivot"   ? drive::Above::pivot
                    : options.corner.above == "round" ? drive::Above::round
                                                      : drive::Above::loop;
    const auto& styles = connect::style_names();
    o.connect.style =
        robot.min_radius <= 0
            ? connect::Style::straight
            : static_cast<connect::Style>(std::ranges::find(styles, options.connect.style) - styles.begin());
    o.connect.extra_length = options.connect.extra_length;
    o.connect.limits = connect::limits_of(robot);
    o.connect.pivot = robot.can_pivot;
    // A rake that stays down would be pushed.
    o.connect.back_up = o.drive.back_up = robot.can_back_up && (robot.lifts || robot.rake_offset == 0);
    // A turn by a takes a / w + w / alpha, and the robot stops for it: v / acceleration more than driving on.
    const double v = robot.travel_speed;
    o.connect.turn_cost = v / robot.turn_rate;
    o.connect.stand_cost = o.drive.stand_cost = v * (v / robot.acceleration + trajectory::Options{}.dwell);
    o.connect.turn_start = v * (robot.turn_rate / robot.turn_acceleration + v / robot.acceleration);
    o.min_gap = options.connect.min_length;
    // Without wheels nothing is spoilt.
    o.avoid.on = options.avoid.finished && !robot.wheels.empty() && robot.min_radius > 0;
    o.avoid.clearance = pipeline::clearance_of(options, robot);
    o.avoid.radius = std::min(least_radius(robot, 1), least_radius(robot, -1));
    o.avoid.crossing_cost = options.avoid.crossing_cost;
    o.avoid.area_cost = options.avoid.area_cost;
    return o;
}

namespace {

void add(Warnings& to, const Warnings& from) { to.insert(to.end(), from.begin(), from.end()); }

// A sample and the states behind it take about half a kilobyte while planning: this many fit a laptop.
constexpr double most_samples = 3e6;

Outcome<void> not_too_long(const std::vector<order::Group>& groups, const Options& options) {
    double drawn = 0;
    for (const order::Group& group : groups)
        for (const Stroke& stroke : group.work.strokes) drawn += length(stroke.rake_path);
    if (drawn / options.trajectory.step <= most_samples) return {};
    return fail("the drive",
                "would draw " + number_text(std::round(drawn / 1000)) + " km, more than " +
                    number_text(most_samples) + " samples " + number_text(options.trajectory.step) +
                    " m apart",
                "make the canvas smaller, trajectory.step larger, or lines of the wide strokes "
                "(robot.fill_wide_strokes=off)");
}

/// What the drawing room dropped by its limits: counted there, said here.
Warnings dropped(const Drawing& drawing, const Options& options) {
    Warnings warnings;
    const auto say = [&](int count, const char* what, const char* key, double limit, const char* unit) {
        if (count > 0)
            warnings.push_back({key, std::to_string(count) + " " + what + " under " + number_text(limit) +
                                         unit + " left out"});
    };
    say(drawing.counts.too_short, "lines", "drawing.min_length", options.drawing.min_length, " m");
    say(drawing.counts.too_small, "areas", "fill.min_area", options.fill.min_area, " m^2");
    const Box canvas{{0, 0}, {drawing.canvas.width, drawing.canvas.height}};
    const auto on_canvas = [&](double x, double y) { return contains(canvas, {x, y}); };
    if (options.tour.has_start && !on_canvas(options.tour.start_x, options.tour.start_y))
        warnings.push_back({"tour.start_x, tour.start_y", "the start lies outside the canvas"});
    if (options.tour.has_end && !on_canvas(options.tour.end_x, options.tour.end_y))
        warnings.push_back({"tour.end_x, tour.end_y", "the end lies outside the canvas"});
    return warnings;
}

void take_account(Plan& plan, const order::Ordered& ordered) {
    Figures& f = plan.figures;
    f.elements = static_cast<int>(plan.drawing.elements.size());
    f.regions = static_cast<int>(std::ranges::count_if(plan.drawing.elements, is_region));
    f.lines = f.elements - f.regions;
    f.strokes = static_cast<int>(plan.strokes.size());
    f.up_straight = ordered.straight;
    f.up_dubins = ordered.dubins;
    f.corners_exact = ordered.exact;
    f.corners_rounded = ordered.rounded;
    f.corners_looped = ordered.loops;
    f.corners_pivoted = ordered.pivots;
    f.direct = ordered.direct;
    f.tour_proven = ordered.tour.proven_optimal && !ordered.reordered;
    f.tour_parts = static_cast<int>(ordered.tour.groups.size());
    f.tour_longer = f.tour_parts > 0 ? ordered.tour.length - ordered.tour.ungrouped : 0;
    f.reproducible = !ordered.tour.stopped;
    for (const drive::Span& span : ordered.undrivable)
        plan.undrivable.push_back(
            {"the bend is tighter than the rake can follow (smooth it, draw it larger, lift "
             "the rake there, or turn on the spot), metres",
             span.at, span.length});
    for (const order::Blemish& b : ordered.blemishes) {
        if (b.metres > 0)
            plan.blemishes.push_back({b.unfinished ? "rolls over what its own area has raked so far, metres"
                                                   : "no way round finished areas found, metres",
                                      b.at, b.metres});
        if (b.crossings > 0)
            plan.blemishes.push_back(
                {b.unfinished ? "crosses its own line, times" : "crosses drawn lines, times", b.at,
                 static_cast<double>(b.crossings)});
    }
    for (const order::Connection& c : ordered.connections)
        plan.connections.push_back({c.from, c.to, c.turn_before, c.turn_after, c.curve});
}

/// Whether all that a plan tells of its samples is told without them: then its figures are taken from the
/// pieces. Where pins are lifted one by one, the drive waits, begins or ends somewhere, or the robot is where
/// it must not be, single samples matter.
bool measured_by_pieces(Plan& plan, const std::vector<trajectory::Placed>& pieces,
                        pipeline::MeasuredPieces& measured) {
    const Options::Park& park = plan.options.park;
    if (park.parked || park.exit != "none" || std::ranges::any_of(plan.strokes, &Stroke::fill) ||
        !pipeline::stops_of(plan).empty())
        return false;
    Figures figures = plan.figures;
    if (!measured.measure(figures, pieces, drive_area_of(plan), plan.robot)) return false;
    plan.figures = figures;
    return true;
}

/// Kicks of the search for a draft whose row cannot be mended: a tenth of the time of a full search for 90
/// elements, and a little longer a way.
constexpr int draft_moves = 200;

Outcome<order::Ordered> in_order(const order::Job& job, const Robot& robot, const Options& options,
                                 pipeline::Kept& kept, bool draft, const Progress& progress) {
    Options same = options;
    same.tour.moves = 0;
    same.tour.time_limit = 0;
    if (kept.robot != robot || kept.options != same) {
        kept.order = {};
        kept.robot = robot;
        kept.options = std::move(same);
    }
    order::Options search = pipeline::order_options(options, robot);
    if (draft) {
        if (auto mended = order::mended(job, robot, search, kept.order, progress)) return std::move(*mended);
        if (search.tour.moves == 0 || search.tour.moves > draft_moves) search.tour.moves = draft_moves;
    }
    return order::ordered(job, robot, search, progress, &kept.order);
}

}  // namespace

Options defaults_for(const Canvas& canvas) {
    Options options;
    const DrawingOptions scaled = options_for(canvas);
    const double share = scaled.margin / options.canvas.margin;
    options.canvas.width = canvas.width;
    options.canvas.height = canvas.height;
    options.canvas.margin = scaled.margin;
    options.drawing.tolerance = scaled.tolerance;
    options.drawing.join_tolerance = scaled.join_tolerance;
    options.drawing.min_length = scaled.min_length;
    options.fill.min_area *= share * share;
    options.connect.min_length *= share;
    // What the settings table allows at the least.
    options.trajectory.step = std::max(options.trajectory.step * share, 1e-4);
    return options;
}

Outcome<void> valid(const Options& options, const Robot& robot) {
    if (options.connect.style == "straight" && robot.min_radius > 0 && !robot.can_pivot)
        return fail(
            "connect.style",
            "straight connections need a robot that turns on the spot, and " + robot.name + " does not",
            "use bounded, or set robot.can_pivot=on where the robot can");
    if (options.corner.above == "pivot" && robot.min_radius > 0 && !robot.can_pivot)
        return fail("corner.above",
                    "pivot needs a robot that turns on the spot, and " + robot.name + " does not",
                    "use loop or round, or set robot.can_pivot=on where the robot can");
    if (auto fits = pipeline::valid_fill(options, robot); !fits) return fits;
    if (auto fits = pipeline::valid_surroundings(options); !fits) return fits;
    const auto rules = rules_of(options.drawing.rules);
    if (!rules) return tl::unexpected(rules.error());
    for (const InkRule& rule : *rules)
        for (const svg::Hint& hint : rule.hints)
            if (auto fits = pipeline::valid_for(hint, robot); !fits) {
                fits.error().place = "drawing.rules, " + fits.error().place;
                return fits;
            }
    return {};
}

Outcome<Plan> pipeline::planned(const Read& read, Drawing drawing, const std::string& title,
                                const Robot& robot, const Options& options, const std::vector<Edit>& edits,
                                Kept& kept, std::vector<trajectory::Placed>* draft,
                                const Progress& progress) {
    std::vector<std::string> idle = pipeline::apply_to_drawing(drawing, edits, robot);
    pipeline::Strokes strokes =
        pipeline::strokes_of(drawing, robot, options, kept.strokes, patient(progress));
    if (strokes.groups.empty()) {
        Error error{title, "nothing of the drawing can be raked at this size",
                    "make the canvas larger, or choose a narrower rake"};
        // Which element, and what was asked for it.
        if (!strokes.warnings.empty()) error.reason += " (" + sentence(strokes.warnings.front()) + ")";
        return tl::unexpected(error);
    }
    if (const auto bearable = not_too_long(strokes.groups, options); !bearable)
        return tl::unexpected(bearable.error());
    order::Job job;
    job.groups = std::move(strokes.groups);
    job.start = drawing.start;
    if (options.tour.has_start) job.start = Point{options.tour.start_x, options.tour.start_y};
    if (options.tour.has_end) job.end = Point{options.tour.end_x, options.tour.end_y};
    job.batches = pipeline::batches_of(job.groups, drawing);
    if (options.tour.inner_first) job.before = pipeline::inner_before_outer(job.groups, drawing);

    Plan plan;
    plan.title = title;
    plan.robot = robot;
    plan.options = options;
    plan.edits = edits;
    add(plan.warnings, read.wrong_hints);
    for (const std::string& gone : pipeline::apply_edits(job, pipeline::entries_asked(drawing)))
        plan.warnings.push_back({"hint start", gone});
    plan.idle_edits = std::move(idle);
    for (std::string& gone : pipeline::apply_edits(job, edits)) plan.idle_edits.push_back(std::move(gone));
    pipeline::keep_within_batches(job);
    pipeline::add_surroundings(job, drawing, options, robot);
    auto ordered = in_order(job, robot, options, kept, draft != nullptr, progress);
    if (!ordered) return tl::unexpected(ordered.error());
    for (std::size_t i = 0; i < job.shapes.size(); ++i)
        if (const order::Shape& shape = job.shapes[i]; !ordered->unshaped[i].empty())
            plan.idle_edits.push_back(
                (shape.hop ? "through: within \"" : "through: from \"") +
                job.groups[static_cast<std::size_t>(shape.a)].name +
                (shape.hop ? "" : "\" to \"" + job.groups[static_cast<std::size_t>(shape.b)].name) +
                "\": " + ordered->unshaped[i]);

    plan.drawing = std::move(drawing);
    plan.strokes = std::move(ordered->strokes);
    plan.order = std::move(ordered->entries);
    const trajectory::Options spaced{.step = options.trajectory.step};
    if (!draft) {
        plan.samples = trajectory::timed(legs_of(ordered->stretches), plan.strokes, robot, spaced);
    } else {
        *draft = kept.pieces.timed(ordered->stretches, plan.strokes, robot, spaced);
        if (!measured_by_pieces(plan, *draft, kept.measured)) {
            plan.samples = trajectory::joined(*draft);
            draft->clear();
        }
    }
    const Warnings unlifted = pipeline::lift_pins(plan.samples, plan.strokes, plan.drawing, robot, options);
    pipeline::Fills fills = pipeline::account_for(job.groups, ordered->variants, kept.strokes, progress);
    plan.figures.fill_area = fills.account.area;
    plan.figures.fill_swept = fills.swept;
    plan.figures.fill_coverage = fills.account.coverage;
    plan.figures.fill_overdraw = fills.account.overdraw;
    plan.figures.fill_spill = fills.account.spill;
    plan.figures.fill_hops = fills.account.hops;
    plan.figures.fill_drives_over = fills.account.drives_over;
    plan.bare = std::move(fills.bare);
    plan.figures.fallbacks =
        strokes.fallbacks + static_cast<int>(unlifted.size() + read.wrong_hints.size()) + ordered->fallbacks;
    take_account(plan, *ordered);
    if (!plan.samples.empty()) parts::measure(plan.figures, plan.samples);
    add(plan.warnings, read.document.warnings);
    add(plan.warnings, plan.drawing.warnings);
    add(plan.warnings, dropped(plan.drawing, options));
    add(plan.warnings, strokes.warnings);
    add(plan.warnings, ordered->warnings);
    add(plan.warnings, unlifted);
    plan.stops = pipeline::stops_of(plan);
    pipeline::take_surroundings(plan);
    pipeline::say_shortfalls(plan);
    return plan;
}

}  // namespace strandline
