// Parallel lines, segment by segment, and rings along the outline last.
#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "path/fill/narrow.hpp"
#include "path/fill/units.hpp"

namespace strandline::fill {
namespace {

// Of the width: each corner costs an inset a round that crosses all others within half a width.
constexpr double outline_thinning = 0.005, corridor_thinning = 0.02;

/// What a plan points to, at a place of its own.
struct Parts {
    std::vector<std::vector<Line>> lines;
    std::vector<OtherFill> others;
};

/// The outlines of the insets by half a width and further spacings.
void add_nested(const Region& region, const Options& options, std::vector<Ring>& nested) {
    const double thinning = corridor_thinning * options.width;
    const auto plain_inset = [&](const Regions& regions, double by) {
        return inset(simplified(regions, thinning), by, thinning);
    };
    Regions room = plain_inset({region}, options.width / 2);
    for (int level = 0; !room.empty(); ++level, room = plain_inset(room, options.spacing))
        for (const Region& part : room) {
            nested.push_back(ring_of(part.outer, level, true));
            for (const Polygon& hole : part.holes) nested.push_back(ring_of(hole, level, true));
        }
}

}  // namespace

OtherFill other_fill(const Segment& segment, const Region& region, const std::string& place,
                     const Options& options, Fill& account) {
    const double share = (options.width - options.spacing) / 2;
    const Regions target = simplified(segment.target, outline_thinning * options.width);
    OtherFill other;
    for (const Region& part :
         share > 0 ? intersected(inset(target, -share, outline_thinning * options.width), {region})
                   : target) {
        std::vector<Pass> passes = (*segment.style == Style::spiral ? spiral_passes : ring_passes)(
            part, place, options, account)({});
        // Sand beside a border is never too narrow to be raked.
        const NarrowParts narrow = narrow_parts(part, options);
        passes = with_arms(std::move(passes), narrow, options);
        if (passes.empty()) {
            const Point at = point_inside(part);
            account.warnings.push_back(
                {place, fmt::format("the segment near ({:.2f}, {:.2f}) is too narrow for its style and left "
                                    "bare: choose zigzag there",
                                    at.x, at.y)});
            continue;
        }
        std::ranges::move(passes, std::back_inserter(other.passes));
        add_nested(part, options, other.corridors);
        for (const Arm& arm : narrow.arms)
            if (!arm.line.empty()) other.corridors.push_back(ring_of(arm.line, 0, false));
    }
    return other;
}

Passes zigzag_passes(const Region& region, const std::string& place, const Options& options, Fill& account) {
    const double w = options.width;
    constexpr double plain_share = 0.001;  // of the width: less than that no sand shows
    const Regions plain = simplified({region}, plain_share * w);
    const Region& outline = plain.size() == 1 ? plain[0] : region;
    Regions room = room_for_centre(outline, place, options, account);
    if (room.empty()) return no_passes;
    const Regions target =
        options.border ? inset(room, options.spacing / 2, plain_share * w) : Regions{outline};
    const auto parts = std::make_shared<Parts>();
    for (const Segment& segment : segments_of(outline, target, place, options, account)) {
        if (!segment.style)
            parts->lines.push_back(lines_of(segment, {outline}, options));
        else if (OtherFill other = other_fill(segment, outline, place, options, account);
                 !other.passes.empty())
            parts->others.push_back(std::move(other));
    }
    std::vector<Ring> borders;
    if (options.border)
        for (const Region& part : room) {
            borders.push_back(ring_of(part.outer, 0, true));
            for (const Polygon& hole : part.holes) borders.push_back(ring_of(hole, 0, true));
        }
    Plan plan = planned(parts->lines, parts->others, borders, room, options);
    return [parts, plan = std::move(plan), room = std::move(room), options](const Wish& wish) {
        return driven(plan, room, wish, options);
    };
}

}  // namespace strandline::fill
