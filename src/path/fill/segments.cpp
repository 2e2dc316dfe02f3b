// What is raked by one set of parallel lines, and in which direction.
#include <fmt/core.h>

#include <algorithm>

#include "path/fill/cuts.hpp"
#include "path/fill/waste.hpp"
#include "path/fill/zigzag.hpp"

namespace strandline::fill {
namespace {

constexpr double plain_share = 0.25;  // of the width: corners that matter to where an area is cut
constexpr double cut_share = 0.001;   // of the width: how wide a cut is
constexpr std::size_t tried_directions = 3;
constexpr double strip_share = 1.5;  // of the width: the border's strip belongs to the segment beside it

Regions without_line(const Regions& regions, const Polyline& cut, const Options& options) {
    return subtracted(regions, swept({cut}, false, cut_share * options.width / 2, Cap::square));
}

/// What cuts leave of a piece, but for what is left to its neighbours' overlap.
Regions large_parts(const Region& piece, const std::vector<Polyline>& cuts, const Options& options) {
    Regions parts{piece};
    for (const Polyline& line : cuts) parts = without_line(parts, line, options);
    std::erase_if(
        parts, [&](const Region& part) { return area(part) < least_part * options.width * options.width; });
    return parts;
}

/// What the user's cuts leave in one piece each; which of them part something is written down.
Regions cut_up(Regions target, const Options& options, Fill& account) {
    for (std::size_t i = 0; i < options.cuts.size(); ++i) {
        if (options.cuts[i].size() < 2) continue;
        Regions parts = without_line(target, options.cuts[i], options);
        if (parts.size() <= target.size()) continue;
        target = std::move(parts);
        account.cuts_used[i] = true;
    }
    return target;
}

Region plain_of(const Region& area, const Options& options) {
    const Regions plain = simplified({area}, plain_share * options.width);
    return plain.size() == 1 ? plain[0] : area;
}

/// The part with the best direction by its true lines, of those that are best by its edges.
Segment directed(Region part, const Options& options) {
    Segment best{{std::move(part)}, 0};
    double least = std::numeric_limits<double>::infinity();
    Segment trial{best.target, 0};
    for (const Waste& waste :
         least_wastes(plain_of(best.target[0], options), options.direction, tried_directions, options)) {
        trial.direction = waste.direction;
        const double area = options.direction ? 0 : waste_of(trial, options);
        if (area >= least - 1e-9) continue;
        least = area;
        best.direction = waste.direction;
    }
    return best;
}

/// The segments of one piece where that wastes less than one direction for all of it.
std::vector<Segment> fitted_segments(const Region& piece, const Options& options) {
    std::vector<Segment> whole{directed(piece, options)};
    const std::vector<Polyline> cuts = fitted_cuts(plain_of(piece, options), options);
    if (cuts.empty()) return whole;
    std::vector<Segment> parts;
    double waste = cut_cost(options) * static_cast<double>(cuts.size());
    for (Region& part : large_parts(piece, cuts, options)) {
        parts.push_back(directed(std::move(part), options));
        waste += waste_of(parts.back(), options);
    }
    return waste < waste_of(whole[0], options) ? parts : whole;
}

/// What may have a direction or a style of its own: a part of a piece that the cuts leave.
struct Part {
    Region region;
    std::optional<double> direction = {};  ///< that of the piece it is of
};

std::vector<Part> parts_of(const Regions& target, const std::string& place, const Options& options,
                           Fill& account) {
    std::vector<Part> parts;
    for (const Region& piece : cut_up(target, options, account)) {
        Partition partition = options.partition;
        if (partition == Partition::optimal_convex) {
            const auto convex = convex_cuts(plain_of(piece, options), options);
            if (convex) {
                for (Region& part : large_parts(piece, *convex, options)) parts.push_back({std::move(part)});
                continue;
            }
            account.warnings.push_back(
                {place, fmt::format("{}: the monotone partition is used", convex.error().reason)});
            partition = Partition::monotone;
        }
        // Parts in which every line is in one piece share their rows, unless sand is to stay between them:
        // rows for each by itself would round their number up in every part.
        if (partition == Partition::monotone && options.part_inset > 0) {
            const double direction = directed(piece, options).direction;
            for (Polygon& part : monotone_parts(piece, direction))
                parts.push_back({{std::move(part), {}}, direction});
        } else {
            parts.push_back({piece});
        }
    }
    return parts;
}

double distance_to(const Region& region, Point p) {
    if (contains(region, p)) return 0;
    double least = distance_to_outline(region.outer, p);
    for (const Polygon& hole : region.holes) least = std::min(least, distance_to_outline(hole, p));
    return least;
}

/// What is chosen for each part. A choice beside the parts, in the border's strip, is for the nearest one.
std::vector<SegmentChoice> chosen(const std::vector<Part>& parts, const Region& region,
                                  const std::string& place, const Options& options, Fill& account) {
    std::vector<SegmentChoice> of_part(parts.size());
    for (std::size_t i = 0; i < options.segments.size(); ++i) {
        const SegmentChoice& choice = options.segments[i];
        double least = strip_share * options.width;
        SegmentChoice* best = nullptr;
        for (std::size_t k = 0; contains(region, choice.at) && k < parts.size(); ++k)
            if (const double d = distance_to(parts[k].region, choice.at); d < least)
                least = d, best = &of_part[k];
        if (!best) continue;
        account.segments_used[i] = true;
        const auto overrules = [&](const auto& mine, const auto& before) {
            return mine && before && *mine != *before;
        };
        if (overrules(choice.direction, best->direction) || overrules(choice.style, best->style))
            account.warnings.push_back(
                {place, fmt::format("segment choice {} is for a part that an earlier one is for too, and "
                                    "overrules it: a cut between their points parts them",
                                    i + 1)});
        if (choice.direction) best->direction = choice.direction;
        if (choice.style) best->style = choice.style;
    }
    return of_part;
}

}  // namespace

std::vector<Segment> segments_of(const Region& region, const Regions& target, const std::string& place,
                                 const Options& options, Fill& account) {
    std::vector<Segment> segments;
    const auto add = [&](Segment segment) {
        if (options.part_inset > 0) segment.target = inset(segment.target, options.part_inset);
        if (!segment.target.empty()) segments.push_back(std::move(segment));
    };
    std::vector<Part> parts = parts_of(target, place, options, account);
    const std::vector<SegmentChoice> choices = chosen(parts, region, place, options, account);
    Options own = options;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        auto& [part, direction] = parts[i];
        own.direction = choices[i].direction ? choices[i].direction : options.direction;
        if (choices[i].style.value_or(Style::zigzag) != Style::zigzag)
            add({{std::move(part)}, 0, choices[i].style});
        else if (direction && !choices[i].direction)
            add({{std::move(part)}, *direction});
        else if (options.partition == Partition::fitted)
            for (Segment& segment : fitted_segments(part, own)) add(std::move(segment));
        else
            add(directed(std::move(part), own));
    }
    return segments;
}

}  // namespace strandline::fill
