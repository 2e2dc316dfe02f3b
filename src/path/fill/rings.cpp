// Rings from nested insets, and what is left between them.
#include "path/fill/rings.hpp"

#include <algorithm>

#include "path/fill/comb.hpp"
#include "path/fill/corners.hpp"

namespace strandline::fill {
namespace {

// All of these are shares of the rake's width or its square.
constexpr double thinnest_ring =
    0.12;  // half the width of what a ring goes round: thinner, it is one place twice
constexpr double gap_margin = 0.02;        // gaps thinner than twice that are chords against arcs
constexpr double least_masked_gap = 0.02;  // area: the same where what is raked twice is lifted over
constexpr double least_gap = 0.12;         // area: less in the middle of a ring is not worth a pass
constexpr double least_neck = 0.3;         // area: nor is less beside a ring
constexpr double tooth_price = 0.04;       // area that a tooth of a comb must save: each costs a lift
constexpr double neck_margin = 0.05;       // area beyond what mitred corners explain: there is a neck
constexpr double longest_tip = 1.2;        // of (width / 2)^2: the tip of a corner of 45 degrees
constexpr double fine = 200,
                 coarse = 50;  // widths a tolerance: outlines are thinned, of very rough areas more
constexpr std::size_t many_corners = 1000;
constexpr double axis_thinning = 0.03;
constexpr double hop_price = 0.6;        // area that a further piece must save: the way there is a hop
constexpr double driven_price = 0.6;     // a length of path over finished sand, times the width
constexpr double bare_price = 4;         // bare sand against sand raked twice
constexpr double masked_bare_price = 2;  // the same with pins: raked sand is lifted over
constexpr double masked_price = 0.1;     // a pass, when what it rakes twice is lifted over
constexpr double least_waste = 0.02;     // of a place: less is not worth a trial
constexpr double trial_cell = 1 / 8.0;   // the raster on which choices are tried
constexpr double spine_thinning = 0.02;
constexpr int most_trial_levels = 4;  // rings within a narrow place: with more the misfit is a small share
constexpr int plain_levels = 1;       // with more, combs are tried only round a few holes
constexpr std::size_t most_holes = 3;
constexpr int most_levels = 4000;

/// Sand that nothing outside of it rakes, and what serves it: rings along the outlines of `centre` with the
/// places within and beside them, or a choice that replaces them all.
struct Place {
    Region sand;
    Regions centre;
    int level = 0;
    std::vector<Ring> rings = {};
    std::vector<std::size_t> parts = {};  // further places
    int levels = 0;                       // of rings within each other
};

/// What a choice leaves bare (at its price) and rakes twice or outside: square metres.
double waste(const Region& place, const std::vector<Ring>& rings, const Options& options) {
    const unsigned down = rake::all_pins(1);
    std::vector<rake::Move> moves;
    for (const Ring& ring : rings) {
        if (!ring.teeth.empty()) {
            for (const Polyline& tooth : ring.teeth) moves.push_back({tooth, down});
            continue;
        }
        Polyline line = ring.line;
        if (ring.closed) line.push_back(line.front());
        for (Polyline& pass : with_cut_corners(line, ring.closed, ring.level == 0, options))
            moves.push_back({std::move(pass), down});
    }
    const double bare = options.masked ? masked_bare_price : bare_price;
    if (moves.empty()) return bare * area(place);
    const rake::Account account = rake::account_of(
        {place}, moves, {.width = options.width, .pins = 1, .cell_share = trial_cell, .details = false});
    const double twice = options.masked ? masked_price * account.ratio : account.overdraw + account.spill;
    return (bare * (1 - account.coverage) + twice) * area(place) +
           (options.masked ? 0 : driven_price * account.driven_over * options.width);
}

/// A tree of places as a list, parts behind what they are part of: insets may be thousands of levels deep.
class Nesting {
  public:
    Nesting(const Levels& levels, const Options& options, double thinning)
        : levels_(levels), options_(options), w_(options.width), thinning_(thinning) {}

    /// All rings of `region`, whose outermost run along the outlines of `border`.
    std::vector<Ring> rings(const Region& region, const Regions& border) {
        places_.push_back({region, border});
        for (std::size_t i = 0; i < places_.size(); ++i) part(i);
        for (std::size_t i = places_.size(); i-- > 0;) {
            Place& place = places_[i];
            int deepest = 0;
            for (const std::size_t part : place.parts) deepest = std::max(deepest, places_[part].levels);
            place.levels = (place.centre.empty() ? 0 : 1) + deepest;
            if (i > 0) choose(i);
        }
        return served(0);
    }

  private:
    /// Where the rake's centre goes in sand that is raked by rings.
    Regions thinned_centre(const Region& sand, int level) const {
        Regions centre = centre_of(levels_, sand, level, options_);
        for (Region& part : centre) part = thinned_region(part, thinning_);
        std::erase_if(centre, [&](const Region& part) {
            if (part.outer.size() < 3) return true;
            double round = perimeter(part.outer);
            for (const Polygon& hole : part.holes) round += perimeter(hole);
            // The widest disc's radius is at least area / perimeter.
            return area(part) < thinnest_ring * w_ * round && inset({part}, thinnest_ring * w_).empty();
        });
        return centre;
    }

    /// The sand that rings along these outlines would reach if corners were raked to their tips, but for the
    /// tips of sharp ones: Steiner's formula for the parallel outline at half a width, with mitres.
    double reached(const Regions& centre) const {
        double sum = area(centre), turns = 0;
        const auto add = [&](const Polygon& ring) {
            sum += perimeter(ring) * w_ / 2;
            for (std::size_t n = ring.size(), i = 0; i < n; ++i) {
                const Point in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
                const double half = std::atan2(cross(in, out), dot(in, out)) / 2;
                turns += std::min(std::tan(half), half + longest_tip);
            }
        };
        for (const Region& region : centre) {
            add(region.outer);
            for (const Polygon& hole : region.holes) add(hole);
        }
        return sum + turns * w_ * w_ / 4;
    }

    /// Rings along the outlines of a place's centre, and the places within and beside them.
    void part(std::size_t i) {
        const auto add = [&](Region&& sand) {
            const int level = places_[i].level + 1;
            Regions centre = thinned_centre(sand, level);
            places_[i].parts.push_back(places_.size());
            places_.push_back({std::move(sand), std::move(centre), level});
        };
        const Regions centre = places_[i].centre;  // places move when one is added
        const int level = places_[i].level;
        for (const Region& region : centre) {
            const auto add_ring = [&](const Polygon& line) {
                places_[i].rings.push_back(
                    ring_of(level > 0 ? with_pointed_corners(line, options_) : line, level, true));
            };
            add_ring(region.outer);
            for (const Polygon& hole : region.holes) add_ring(hole);
        }
        if (centre.empty() || level >= most_levels) return;
        for (Region& rest : sand_within(levels_, centre, level, options_))
            if (area(rest) > (options_.masked ? least_masked_gap : least_gap) * w_ * w_) add(std::move(rest));
        // Beside the rings: necks narrower than the rake, and corners.
        // At the outline itself nothing fits there: what is served there is narrower than the rake.
        if (level == 0 || area(places_[i].sand) - reached(centre) <= neck_margin * w_ * w_) return;
        const Regions raked = inset(centre, -(0.5 + gap_margin) * w_, w_ / 100);
        for (Region& neck : subtracted({places_[i].sand}, raked))
            if (area(neck) > least_neck * w_ * w_) add(std::move(neck));
    }

    /// What serves a place, outermost first.
    std::vector<Ring> served(std::size_t place) const {
        std::vector<Ring> rings;
        std::vector<std::size_t> open{place};
        while (!open.empty()) {
            const Place& next = places_[open.back()];
            open.pop_back();
            rings.insert(rings.end(), next.rings.begin(), next.rings.end());
            open.insert(open.end(), next.parts.rbegin(), next.parts.rend());
        }
        return rings;
    }

    /// Takes a spine or combs for a place that rings serve worse.
    void choose(std::size_t i) {
        Place& place = places_[i];
        if (place.levels > most_trial_levels) return;
        // Combs serve corridors; in a net of ridges between many holes they only cost time.
        const bool combs = options_.pivots && !options_.masked &&
                           (place.levels <= plain_levels || place.sand.holes.size() <= most_holes);
        if (!place.centre.empty() && !combs) return;
        const std::vector<Ring> plain_rings = served(i);
        const std::size_t served_by = plain_rings.size();
        double least = waste(place.sand, plain_rings, options_);
        if (least < least_waste * area(place.sand)) return;
        const Regions plain = simplified({place.sand}, axis_thinning * w_);
        if (plain.empty()) return;
        if (!place.centre.empty() && !combs_may_pay(plain[0], place.levels, least, w_)) return;
        const std::vector<AxisPath> paths = axis_paths(plain[0], options_);
        // Each way to a further piece is a hop, but legs of a path lie beside each other.
        const auto further = static_cast<double>(paths.size()) - static_cast<double>(served_by);
        const double hops = options_.masked ? 0 : hop_price * w_ * w_ * std::max(0.0, further);
        if (hops >= least) return;
        const auto offer = [&](std::vector<Ring>&& rings) {
            if (rings.empty()) return;
            double its = hops;
            for (const Ring& ring : rings)
                its += tooth_price * w_ * w_ * static_cast<double>(ring.teeth.size());
            if (its >= least) return;  // the trial is dear
            its += waste(place.sand, rings, options_);
            if (its >= least) return;
            least = its;
            place.rings = std::move(rings);
            place.parts.clear();
            place.levels = 1;
        };
        if (place.centre.empty()) {
            std::vector<Ring> spines;
            for (const AxisPath& path : paths)
                spines.push_back(ring_of(thinned(path.line, spine_thinning * w_), place.level, path.closed));
            offer(std::move(spines));
        }
        if (!combs) return;
        offer(combed(plain[0], paths, place.level));
        const std::vector<AxisPath> straight = straightened(paths, options_);
        offer(combed(plain[0], straight, place.level));
        if (const auto legs = parted_at_bends(straight, options_); legs.size() > straight.size())
            offer(combed(plain[0], legs, place.level));
    }

    std::vector<Ring> combed(const Region& sand, const std::vector<AxisPath>& paths, int level) const {
        std::vector<Ring> rings;
        for (Comb& comb : combs_of(sand, paths, options_)) {
            rings.push_back(ring_of(std::move(comb.spine), level, false));
            rings.back().teeth = std::move(comb.teeth);
        }
        return rings;
    }

    const Levels& levels_;
    const Options& options_;
    double w_, thinning_;
    std::vector<Place> places_;
};

}  // namespace

Region thinned_region(const Region& region, double tolerance) {
    Region plain{thinned_outline(region.outer, tolerance), {}};
    for (const Polygon& hole : region.holes)
        if (Polygon outline = thinned_outline(hole, tolerance); outline.size() >= 3)
            plain.holes.push_back(std::move(outline));
    return plain;
}

std::vector<Ring> rings_of(const Region& region, const Levels& levels, const Options& options) {
    Regions border = levels.room;
    std::size_t corners = 0;
    for (Region& part : border) {
        part = thinned_region(part, options.width / fine);
        corners += part.outer.size();
        for (const Polygon& hole : part.holes) corners += hole.size();
    }
    const double thinning = options.width / (corners > many_corners ? coarse : fine);
    return Nesting(levels, options, thinning).rings(region, border);
}

}  // namespace strandline::fill
