#include "plan/pipeline/strokes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>

#include "plan/pipeline/hints.hpp"
#include "plan/pipeline/pins.hpp"
#include "plan/pipeline/unserved.hpp"

namespace strandline::pipeline {
namespace {

// A closed line can be entered at its drawn nodes and at further ones this far apart, but at no more than
// `most_nodes`.
constexpr double node_spacing = 0.25;
constexpr double most_nodes = 64;

// Share of the rake's width between passes: a twentieth overlaps, for a bar that stands a little skew in
// bends.
constexpr double default_spacing = 0.95;
// With fewer pins that lift, a pin less would be much less than the rake.
constexpr int many_pins = 5;
constexpr int variants_offered =
    8;  // of an area's starts and exits, beside the one that is shortest in itself

Point point_along(const std::vector<Curve>& curves, double s) {
    for (const Curve& curve : curves) {
        const double l = length(curve);
        if (s <= l) return point_at(curve, s).pose.at;
        s -= l;
    }
    return end_pose(curves.back()).at;
}

/// Arc lengths of the drawn nodes along the fitted curves: their share of the drawn path, drawn onto a corner
/// of the fit when one is near (the two lengths differ by little more than the tolerance).
std::vector<double> drawn_nodes(const Path& path, const std::vector<Curve>& curves, double tolerance) {
    const double drawn = length(path), fitted = length(curves);
    std::vector<double> corners{0};
    for (const Curve& curve : curves) corners.push_back(corners.back() + length(curve));
    std::vector<double> nodes{0};
    double so_far = 0;
    Point from = path.start;
    for (const Segment& segment : path.segments) {
        so_far += length(Path{from, {segment}, false});
        from = end_of(segment);
        double s = fitted * std::min(1.0, so_far / drawn);
        const auto corner = std::ranges::min_element(corners, {}, [&](double c) { return std::abs(c - s); });
        if (std::abs(*corner - s) < 4 * tolerance + 1e-3 * fitted &&
            distance(point_along(curves, *corner), from) < 4 * tolerance)
            s = *corner;
        nodes.push_back(s);
    }
    return nodes;
}

std::vector<Node> nodes_of(const LineElement& line, const std::vector<Curve>& curves, double tolerance) {
    const double total = length(curves);
    std::vector<Node> nodes;
    if (!line.path.closed)
        return {{0, curves.front().start.at, 0},
                {total, end_pose(curves.back()).at, static_cast<int>(line.path.segments.size())}};
    constexpr double same_place = 1e-6;
    const double spacing = std::max(node_spacing, total / most_nodes);
    const std::vector<double> drawn = drawn_nodes(line.path, curves, tolerance);
    double last = 0;
    const auto fill_up_to = [&](double s) {
        const double parts = std::ceil((s - last) / spacing - 1e-9);
        for (double k = 1; k < parts; ++k) {
            const double at = last + (s - last) * k / parts;
            nodes.push_back({at, point_along(curves, at), -1});
        }
    };
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (i > 0 && drawn[i] <= last + same_place) continue;
        if (i > 0) fill_up_to(drawn[i]);
        if (drawn[i] >= total - same_place) break;
        nodes.push_back({drawn[i], point_along(curves, drawn[i]), static_cast<int>(i)});
        last = drawn[i];
    }
    return nodes;
}

fill::Options fill_options(const Options& options, const Robot& robot) {
    const Options::FillArea& f = options.fill;
    fill::Options o;
    // The table of settings has let through what has a name.
    o.style = *fill::named<fill::Style>(f.style, "fill.style");
    o.insets = *fill::named<fill::Insets>(f.inset, "fill.inset");
    o.join = *fill::named<fill::Join>(f.join, "fill.join");
    o.shift = f.shift;
    o.width = robot.rake_width();
    o.pins = robot.pins;
    o.masked = lifts_pins(options, robot);
    const double fitting =
        o.masked && robot.pins >= many_pins ? o.width - robot.pin_pitch : default_spacing * o.width;
    o.spacing = f.spacing > 0 ? std::min(f.spacing, o.width) : fitting;
    if (!f.best_direction) o.direction = f.direction;
    o.partition = *fill::named<fill::Partition>(f.partition, "fill.partition");
    // What cannot be read, valid() has refused.
    o.cuts = fill::cuts_of(f.cuts, "fill.cuts").value();
    o.segments = fill::segment_choices_of(f.segments, "fill.segments").value();
    o.one_stroke = f.one_stroke;
    o.rake_turns = f.rake_turns;
    o.part_inset = f.part_inset;
    o.min_area = f.min_area;
    o.border = f.border;
    o.narrow = *fill::named<fill::Narrow>(f.narrow, "fill.narrow");
    o.tolerance = options.drawing.tolerance;
    o.variants = variants_offered;
    // The rake can follow radii above its offset, but the nearer to it the more the bar stands skew: at 1.5 L
    // by 42 degrees, and the groove is a quarter narrower.
    o.turn_radius =
        robot.min_radius > 0 && !robot.can_pivot ? 1.5 * std::hypot(robot.rake_offset, robot.rake_side) : 0;
    o.pivots = robot.can_pivot && robot.pins > 1;
    o.tips = *fill::named<fill::Tips>(f.tips, "fill.tips");
    o.round_corners = false;  // drive knows at each corner whether the rake can follow a bend
    return o;
}

void fill_in(Worked& work, const Robot& robot, const Options& options) {
    const Element& element = work.element;
    const auto fall_back = [&](const std::string& place, std::string what) {
        ++work.fallbacks;
        work.warnings.push_back({place, std::move(what)});
    };
    const Options wanted = options_for(element, options);
    fill::Options filling = fill_options(wanted, robot);
    const Region& region = std::get<RegionElement>(element.what).region;
    if (filling.masked && !sees_pins(region, robot)) {
        filling.masked = false;
        if (wanted.fill.spacing <= 0) filling.spacing = default_spacing * filling.width;
        fall_back(element.id, "is too large to lift pins one by one; all are down together");
    }
    fill::Fill filled = fill::fill_region(region, -1, element.id, filling);
    work.fallbacks += static_cast<int>(filled.warnings.size());
    work.warnings.insert(work.warnings.end(), filled.warnings.begin(), filled.warnings.end());
    work.group.work.strokes = std::move(filled.strokes);
    work.group.before = std::move(filled.before);
    work.group.area = {region};
    work.filled = Filled{std::move(filling), {std::move(filled.ways)}};
    for (fill::Variant& variant : filled.variants) {
        work.group.variants.push_back({std::move(variant.strokes), variant.longer});
        work.filled->ways.push_back(std::move(variant.ways));
    }
    work.said = std::move(filled);
}

void go_along(Worked& work, const LineElement& line, double tolerance) {
    Stroke stroke;
    stroke.rake_path = fitted(line.path, {.tolerance = tolerance});
    stroke.closed = line.path.closed;
    stroke.pins = line.pins;
    if (stroke.rake_path.empty()) return;
    stroke.nodes = nodes_of(line, stroke.rake_path, tolerance);
    work.group.work.strokes.push_back(std::move(stroke));
}

/// The element's strokes, which know no index yet.
Worked worked(const Element& element, const Robot& robot, const Options& options) {
    Worked work;
    work.element = element;
    work.group.name = element.id;
    if (const auto* line = std::get_if<LineElement>(&element.what))
        go_along(work, *line, options.drawing.tolerance);
    else
        fill_in(work, robot, options);
    if (work.group.work.strokes.empty())
        work.warnings.push_back({element.id, "nothing of it can be raked; it is left out"});
    return work;
}

/// The strokes of a group, for the element with that index.
order::Group numbered(order::Group group, int element) {
    group.work.element = element;
    for (Stroke& stroke : group.work.strokes) stroke.element = element;
    for (order::Variant& variant : group.variants)
        for (Stroke& stroke : variant.strokes) stroke.element = element;
    return group;
}

/// What no longer stands in the drawing is dropped once it outweighs what does.
void forget_old(KeptStrokes& kept, const Drawing& drawing) {
    if (kept.by_id.size() <= 2 * drawing.elements.size()) return;
    std::set<std::string> there;
    for (const Element& element : drawing.elements) there.insert(element.id);
    std::erase_if(kept.by_id, [&](const auto& entry) { return !there.contains(entry.first); });
}

Fills account_of(const Worked& work, int variant) {
    const auto& [options, ways] = *work.filled;
    const std::vector<Stroke>& driven = order::strokes_of(work.group, variant);
    Fills fills;
    fills.account = fill::account_of(std::get<RegionElement>(work.element.what).region, driven,
                                     ways[static_cast<std::size_t>(variant + 1)], options);
    for (const Stroke& stroke : driven) fills.swept += length(stroke.rake_path) * options.width;
    for (const rake::Gap& gap : fills.account.gaps) fills.bare.push_back({work.element.id, gap.at, gap.area});
    return fills;
}

}  // namespace

Strokes strokes_of(const Drawing& drawing, const Robot& robot, const Options& options, KeptStrokes& kept,
                   const Progress& progress) {
    Strokes strokes;
    if (kept.robot != robot || kept.fill != options.fill || kept.tolerance != options.drawing.tolerance)
        kept = {robot, options.fill, options.drawing.tolerance, {}};
    forget_old(kept, drawing);
    Unserved unserved;
    Spacings spacings;
    for (std::size_t i = 0; i < drawing.elements.size(); ++i) {
        progress.report("filling", static_cast<double>(i) / static_cast<double>(drawing.elements.size()));
        const Element& element = drawing.elements[i];
        Worked& work = kept.by_id[element.id];
        const bool same = work.element.id == element.id && work.element.what == element.what &&
                          work.element.hints == element.hints;
        if (!same) work = worked(element, robot, options);
        if (work.filled) {
            unserved.add(options_for(element, options), work.filled->options, work.said);
            spacings.add(work.filled->options);
        }
        strokes.fallbacks += work.fallbacks;
        strokes.warnings.insert(strokes.warnings.end(), work.warnings.begin(), work.warnings.end());
        if (work.group.work.strokes.empty()) continue;
        strokes.groups.push_back(numbered(work.group, static_cast<int>(i)));
    }
    for (const Warning& warning : unserved.warnings()) {
        ++strokes.fallbacks;
        strokes.warnings.push_back(warning);
    }
    for (const Warning& warning : spacings.warnings()) strokes.warnings.push_back(warning);
    progress.report("filling", 1);
    return strokes;
}

Fills account_for(const std::vector<order::Group>& groups, const std::vector<int>& variants,
                  KeptStrokes& kept, const Progress& progress) {
    Fills fills;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        progress.report("accounting", static_cast<double>(i) / static_cast<double>(groups.size()));
        Worked& work = kept.by_id.at(groups[i].name);
        if (!work.filled) continue;
        auto known = work.accounts.find(variants[i]);
        if (known == work.accounts.end())
            known = work.accounts.emplace(variants[i], account_of(work, variants[i])).first;
        fills.swept += known->second.swept;
        fills.bare.insert(fills.bare.end(), known->second.bare.begin(), known->second.bare.end());
        fills.account = joined(std::move(fills.account), known->second.account);
    }
    std::ranges::stable_sort(fills.bare, std::greater{}, &Spot::amount);
    progress.report("accounting", 1);
    return fills;
}

}  // namespace strandline::pipeline
