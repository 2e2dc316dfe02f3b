// Parallel lines, segment by segment, and rings along the outline last.
#include "path/fill/zigzag.hpp"

#include <algorithm>

namespace strandline::fill {

Passes zigzag_passes(const Region& region, const std::string& place, const Options& options, Fill& account) {
    const double w = options.width;
    constexpr double plain_share = 0.001;  // of the width: less than that no sand shows
    const Regions plain = simplified({region}, plain_share * w);
    const Region& outline = plain.size() == 1 ? plain[0] : region;
    Regions room = room_for_centre(outline, place, options, account);
    if (room.empty()) return no_passes;
    const Regions target =
        options.border ? inset(room, options.spacing / 2, plain_share * w) : Regions{outline};
    std::vector<std::vector<Line>> lines;
    for (const Segment& segment : segments_of(target, place, options, account))
        lines.push_back(lines_of(segment, {outline}, options));
    std::vector<Ring> borders;
    if (options.border)
        for (const Region& part : room) {
            borders.push_back(ring_of(part.outer, 0, true));
            for (const Polygon& hole : part.holes) borders.push_back(ring_of(hole, 0, true));
        }
    return [lines = std::move(lines), borders = std::move(borders), room = std::move(room),
            options](const Wish& wish) { return driven(lines, borders, room, wish, options); };
}

}  // namespace strandline::fill
