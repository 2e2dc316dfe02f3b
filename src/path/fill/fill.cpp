#include "path/fill/fill.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "path/fill/narrow.hpp"
#include "path/fill/precedence.hpp"

namespace strandline::fill {
namespace {

constexpr std::size_t most_named = 5;       // parts that are narrower than the rake; the rest are counted
constexpr double bare_share = 0.03;         // of the area: less is corners that no rake can reach
constexpr double fine = 200;                // widths a tolerance: chords of the border
constexpr std::size_t many_corners = 1000;  // of an outline that is thinned so too
constexpr double rough = 0.02;              // of half the width: arcs where only areas are asked for
constexpr double most_varied = 3000;        // widths driven: in a larger area the way to it hardly matters
constexpr double least_run_out = 0.05, most_run_out = 0.8;  // of the width
// Joints of a pass that turn less (radians) are a bend drawn by chords, where that bulges by less than the
// tolerance.
constexpr double smooth_turn = 0.5;

Stroke stroke_of(const Polyline& line, int element, const Options& options) {
    Stroke stroke;
    stroke.element = element;
    stroke.one_way = stroke.fill = true;
    stroke.pins = options.pins;
    // Rings come as chords of their arcs: a robot that took each joint for a corner would stop there.
    stroke.rake_path =
        fitted(path_through(line, false), {.tolerance = options.tolerance, .smooth_angle = smooth_turn});
    stroke.nodes = {{0, line.front(), -1}, {length(stroke.rake_path), line.back(), -1}};
    return stroke;
}

/// Each corner of an outline costs its inset a round that crosses all others within half a width.
Region thinned_if_rough(const Region& region, double tolerance) {
    std::size_t corners = region.outer.size();
    for (const Polygon& hole : region.holes) corners += hole.size();
    if (corners <= many_corners) return region;
    Region plain = thinned_region(region, tolerance);
    return plain.outer.size() < 3 ? region : plain;
}

std::string metres(Point p) { return fmt::format("({:.2f}, {:.2f})", p.x, p.y); }

/// Names what is narrower than the rake, the longest first, and drops what is smaller than the least area.
void say_narrow(NarrowParts& narrow, const std::string& place, const Options& options, Fill& account) {
    std::vector<const Arm*> longest;
    for (Arm& arm : narrow.arms) {
        if (length(arm.line) * arm.most >= options.min_area) {
            longest.push_back(&arm);
        } else {  // arms are known by their number: it stays, without a line
            arm.line.clear();
            ++account.dropped_parts;
        }
    }
    std::ranges::stable_sort(longest, std::greater{}, [](const Arm* arm) { return length(arm->line); });
    for (std::size_t i = 0; i < longest.size(); ++i) {
        if (i == most_named) {
            account.warnings.push_back(
                {place,
                 fmt::format("and {} more parts that are narrower than the rake", longest.size() - i)});
            break;
        }
        const Arm& arm = *longest[i];
        const std::string part = fmt::format(
            "{} {:.2g} to {:.2g} m wide, {:.2g} m long, from {} to {}: narrower than the rake ({:.2g} m)",
            narrow.bodies.empty() ? "is" : "a part is", arm.least, arm.most, length(arm.line),
            metres(arm.line.front()), metres(arm.line.back()), options.width);
        account.warnings.push_back(
            {place, options.narrow == Narrow::warn ? part + "; left bare, as narrow=warn asks"
                    : options.masked ? part + "; one pass along its middle, its pins lifted outside"
                                     : fmt::format("{}; one pass along its middle, up to {:.2g} m outside",
                                                   part, (options.width - arm.least) / 2)});
    }
}

/// An area that is narrower than the rake, but has no parallel sides: one pass from tip to tip, if that is
/// how it is.
NarrowParts middle_part(const Region& region, const Options& options) {
    const Polyline middle = region.holes.empty() ? middle_line(region.outer, options.width) : Polyline{};
    if (middle.size() < 2) return {{}, {}, {}, {}, {region}};
    return {{}, {}, {}, {{middle, Arm::free, Arm::free, 0, area(region) / length(middle)}}, {region}};
}

/// What neither the passes nor the arms can reach: tips.
void say_bare(const Region& region, const NarrowParts& narrow, const std::string& place,
              const Options& options, Fill& account) {
    const double half = options.width / 2;
    Regions bare = narrow.bare;
    std::vector<Polyline> lines;
    for (const Arm& arm : narrow.arms)
        if (!arm.line.empty()) lines.push_back(arm.line);
    if (!lines.empty()) bare = subtracted(bare, swept(lines, false, half * 1.01, Cap::square));
    if (area(bare) <= std::max(options.min_area, bare_share * area(region))) return;
    const auto largest = std::ranges::max_element(bare, {}, [](const Region& part) { return area(part); });
    account.warnings.push_back(
        {place,
         fmt::format("{:.2g} m2 in corners is too narrow for the rake and left bare, most of it near {}",
                     area(bare), metres(point_inside(*largest)))});
}

/// The passes with the ways between them raked too.
std::vector<Pass> in_one_stroke(std::vector<Pass> passes) {
    if (passes.size() < 2) return passes;
    Pass whole = std::move(passes.front());
    for (std::size_t i = 1; i < passes.size(); ++i)
        for (const Polyline* part : {&passes[i].way, &passes[i].line})
            whole.line.insert(whole.line.end(), part->begin(), part->end());
    return {std::move(whole)};
}

/// From `at` along the unit vector `ahead` to the outline, metres; infinity if it is never met.
double way_out(const Region& region, Point at, Point ahead) {
    double least = std::numeric_limits<double>::infinity();
    const auto meet = [&](const Polygon& ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Point edge = ring[i] - ring[j];
            const double across = cross(ahead, edge);
            if (across == 0) continue;
            const double share = cross(ring[j] - at, ahead) / across;
            const double t = cross(ring[j] - at, edge) / across;
            if (t > 0 && share >= 0 && share <= 1) least = std::min(least, t);
        }
    };
    meet(region.outer);
    for (const Polygon& hole : region.holes) meet(hole);
    return least;
}

/// Where pins lift, a pass that ends near an edge ahead of it goes on to it: the corner is filled, and what
/// is raked already stays as it is.
void drive_out(Polyline& line, const Region& region, const Options& options) {
    for (int end = 0; end < 2; ++end) {
        std::ranges::reverse(line);
        if (line.size() < 2 || distance(line[line.size() - 2], line.back()) == 0) continue;
        const Point ahead = normalized(line.back() - line[line.size() - 2]);
        const double out = way_out(region, line.back(), ahead);
        if (out > least_run_out * options.width && out < most_run_out * options.width)
            line.push_back(line.back() + out * ahead);
    }
}

double driven(const std::vector<Pass>& passes) {
    double sum = 0;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        sum += length(passes[i].line);
        if (i == 0) continue;
        Polyline way{passes[i - 1].line.back()};
        way.insert(way.end(), passes[i].way.begin(), passes[i].way.end());
        way.push_back(passes[i].line.front());
        sum += length(way);
    }
    return sum;
}

/// Starts and exits worth offering: towards the four sides of the area, alone and together.
std::vector<Wish> wishes_for(const Region& region) {
    std::vector<Point> sides;
    for (const Point& ahead : {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}})
        sides.push_back(*std::ranges::max_element(region.outer, {}, [&](Point p) { return dot(p, ahead); }));
    std::vector<Wish> wishes;
    for (const Point& side : sides) wishes.push_back({{}, side});
    for (const Point& side : sides) wishes.push_back({side, {}});
    for (const Point& start : sides)
        for (const Point& exit : sides) wishes.push_back({start, exit});
    return wishes;
}

/// Passes -> strokes and ways.
template <class Target>
void put(std::vector<Pass> passes, int element, const Options& options, Target& target) {
    for (Pass& pass : passes) {
        target.strokes.push_back(stroke_of(pass.line, element, options));
        target.ways.push_back(std::move(pass.way));
    }
}

/// Offers what wishes lead to, where that is apart in start or exit from `first` and from each other.
void add_variants(const Region& region, int element, const std::vector<Pass>& first, const Passes& planned,
                  const Options& options, Fill& fill) {
    // The strokes of a fill with several are put in order by who drives them.
    if (options.variants <= 0 || first.size() != 1) return;
    const double length = driven(first);
    if (length > most_varied * options.width) return;
    std::vector<std::pair<Point, Point>> ends{{first.front().line.front(), first.back().line.back()}};
    for (const Wish& wish : wishes_for(region)) {
        if (static_cast<int>(fill.variants.size()) >= options.variants) return;
        std::vector<Pass> passes = planned(wish);
        const std::pair mine{passes.front().line.front(), passes.back().line.back()};
        const auto same = [&](const auto& other) {
            return distance(mine.first, other.first) <= options.width &&
                   distance(mine.second, other.second) <= options.width;
        };
        if (std::ranges::any_of(ends, same)) continue;
        ends.push_back(mine);
        Variant variant{{}, {}, driven(passes) - length};
        put(std::move(passes), element, options, variant);
        fill.variants.push_back(std::move(variant));
    }
}

}  // namespace

Regions room_for_centre(const Region& region, const std::string& place, const Options& options,
                        Fill& account) {
    const double half = options.width / 2;
    Regions room = inset({thinned_if_rough(region, options.width / fine)}, half, options.width / fine);
    const auto too_small = [&](const Region& part) {
        return area(part) < options.min_area && area(inset({part}, -half, rough * half)) < options.min_area;
    };
    for (const Region& part : room)
        if (too_small(part))
            account.warnings.push_back({place, fmt::format("the part near {} is smaller than {} m2: left out",
                                                           metres(part.outer.front()), options.min_area)});
    account.dropped_parts += static_cast<int>(std::erase_if(room, too_small));
    return room;
}

rake::Account account_of(const Region& region, const std::vector<Stroke>& strokes,
                         const std::vector<Polyline>& ways, const Options& options) {
    const rake::Rake rake{options.width, options.pins, options.tolerance};
    std::vector<rake::PinSpans> masks;
    if (options.masked) masks = rake::pin_masks({region}, strokes, ways, rake);
    return rake::account_of({region}, rake::moves_of(strokes, ways, masks, rake.pins, rake.tolerance),
                            {.width = rake.width, .pins = rake.pins});
}

Fill fill_region(const Region& region, int element, const std::string& place, const Options& asked) {
    Options options = asked;
    if (options.one_stroke) options.pivots = false, options.tips = Tips::off;  // a cut corner is a lift
    Fill fill;
    fill.area = area(region);
    fill.cuts_used.resize(options.cuts.size());
    fill.segments_used.resize(options.segments.size());
    const Passes passes_of = (options.style == Style::zigzag   ? zigzag_passes
                              : options.style == Style::spiral ? spiral_passes
                                                               : ring_passes)(region, place, options, fill);
    NarrowParts narrow = narrow_parts(region, options);
    std::vector<Pass> passes = passes_of({});
    if (passes.empty() && narrow.arms.empty()) narrow = middle_part(region, options);
    say_narrow(narrow, place, options, fill);
    say_bare(region, narrow, place, options, fill);
    const auto served = [](const Arm& arm) { return !arm.line.empty(); };
    if (passes.empty() && std::ranges::none_of(narrow.arms, served)) {
        if (narrow.arms.empty()) ++fill.dropped_parts;  // else they are counted
        fill.warnings.push_back(
            {place, fmt::format("is narrower than the rake ({:.2g} m) or smaller than {} m2: not filled",
                                options.width, options.min_area)});
    }
    const auto finished = [&](std::vector<Pass> made) {
        if (options.narrow == Narrow::single_pass) made = with_arms(std::move(made), narrow, options);
        if (options.one_stroke) made = in_one_stroke(std::move(made));
        if (options.masked && !options.pivots)  // else corners are cut
            for (Pass& pass : made) drive_out(pass.line, region, options);
        return made;
    };
    passes = finished(std::move(passes));
    for (const Pass& pass : passes) fill.swept += length(pass.line) * options.width;
    add_variants(
        region, element, passes, [&](const Wish& wish) { return finished(passes_of(wish)); }, options, fill);
    put(std::move(passes), element, options, fill);
    fill.before = precedence(fill.strokes, options.width);
    return fill;
}

}  // namespace strandline::fill
