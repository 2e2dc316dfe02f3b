// In what order the lines and border rings are raked, and how the rake gets from one to the next.
// Key: a unit may be next when what is left without it stays connected.
#include <algorithm>
#include <functional>
#include <utility>

#include "path/fill/corners.hpp"
#include "path/fill/units.hpp"

namespace strandline::fill {
namespace {

// Shares of the rake's width:
constexpr double leap = 1.2;          // along a line: the way to the next line first leaves the raked one
constexpr double dead_end_cost = 20;  // ending where no sand that is still to come is near
constexpr double early_ring_cost =
    3;  // a border ring before a cell that reaches it: its turns would lie on the ring
constexpr double exit_cost = 2;   // a metre away from the exit that is wished for, against a metre of way
constexpr double turn_reach = 3;  // of the spacing: the longest raked turn

/// A unit's way in: from its first line or its last, from the left or from the right; of a ring: the stop.
struct Entry {
    int unit = -1, stop = -1, end = -1;
    bool from_top = false, from_right = false;
    double cost = std::numeric_limits<double>::infinity();
    Polyline way;
};
std::vector<Entry> entries_of(const Plan& plan, int u) {
    const Unit& unit = plan.units[u];
    std::vector<Entry> entries;
    if (unit.ring) {
        for (int stop : plan.corridors.of[unit.corridors[0]].stops)
            entries.push_back({u, stop, stop, false, false, 0, {}});
        return entries;
    }
    if (unit.other) return {{u, unit.first, unit.last, false, false, 0, {}}};
    const bool odd = unit.corridors.size() % 2 == 1;
    for (bool top : {false, true})
        for (bool right : {false, true}) {
            const int first = top ? unit.corridors.back() : unit.corridors.front();
            const int last = top ? unit.corridors.front() : unit.corridors.back();
            entries.push_back(
                {u, plan.ends_of[first][right], plan.ends_of[last][right != odd], top, right, 0, {}});
        }
    return entries;
}

/// Whether something of another unit that is still to come is next to a stop.
bool leads_on(const Plan& plan, const std::vector<bool>& done, int stop, int unit) {
    const auto leads = [&](int from) {
        return std::ranges::any_of(plan.corridors.stops[from].links, [&](int other) {
            const int there = plan.unit_of[plan.corridors.stops[other].corridor];
            return there != unit && !done[there];
        });
    };
    if (leads(stop)) return true;
    const int corridor = plan.corridors.stops[stop].corridor;
    if (!plan.line_of[corridor]) return false;
    return leads(plan.near_ends_of[corridor][plan.ends_of[corridor][0] == stop ? 0 : 1]);
}

/// The cheapest entry of all that may be next.
Entry next_entry(const Plan& plan, const std::vector<bool>& done, int left, int here, Router& router,
                 const Wish& wish, const Options& options) {
    const Ties ties = ties_of(plan, done);
    const auto units = static_cast<int>(plan.units.size());
    std::vector<bool> may(plan.units.size(), false);
    for (int u = 0; u < units; ++u)
        may[u] = !done[u] && (plan.units[u].outermost ? ties.group_size[u] == 1 : !ties.needed[u]);
    // A cell that holds two outermost rings together parts what is left; so be it.
    const auto none = [&] { return std::ranges::none_of(may, std::identity{}); };
    if (none())
        for (int u = 0; u < units; ++u) may[u] = !done[u] && !plan.units[u].ring;
    if (none())
        for (int u = 0; u < units; ++u) may[u] = !done[u];
    std::vector<std::vector<Entry>> at_stop(plan.corridors.stops.size());
    Entry best;
    for (int u = 0; u < units; ++u) {
        if (!may[u]) continue;
        for (Entry& entry : entries_of(plan, u)) {
            if (left > 1 && !leads_on(plan, done, entry.end, u)) entry.cost += dead_end_cost * options.width;
            if (plan.units[u].ring)
                entry.cost += early_ring_cost * options.width *
                              std::ranges::count_if(plan.neighbours[u], [&](int v) { return !done[v]; });
            if (left == 1 && wish.exit)
                entry.cost += exit_cost * distance(plan.corridors.stops[entry.end].at, *wish.exit);
            if (left == units && wish.start)
                entry.cost += distance(plan.corridors.stops[entry.stop].at, *wish.start);
            at_stop[entry.stop].push_back(entry);
        }
    }
    const auto offer = [&](const Entry& entry, double cost) {
        if (entry.cost + cost >= best.cost) return;
        best = entry;
        best.cost += cost;
    };
    if (here < 0) {
        for (const auto& entries : at_stop)
            for (const Entry& entry : entries) offer(entry, 0);
    } else {
        router.start(here);
        while (const auto reached = router.next()) {
            if (reached->cost >= best.cost) break;
            for (const Entry& entry : at_stop[reached->stop]) offer(entry, reached->cost);
        }
        if (best.unit >= 0) best.way = router.way_to(best.stop);
        const Point from = plan.corridors.stops[here].at;
        if (best.unit < 0)
            for (const auto& entries : at_stop)
                for (const Entry& entry : entries)
                    offer(entry, distance(from, plan.corridors.stops[entry.stop].at));
    }
    if (best.unit < 0)  // rings that nothing comes near
        for (int u = 0; u < units && best.unit < 0; ++u)
            if (may[u]) best = {u, -1, -1, false, false, 0, {}};
    return best;
}

/// The ways and passes as they come; joins what the rake does not lift for.
class Drive {
  public:
    Drive(const Regions& room, const Options& options)
        : options_(options),
          floor_(options.rake_turns && !options.one_stroke ? inset(room, -0.01 * options.width) : Regions{}) {
    }
    bool begun() const { return !passes_.empty(); }
    Point here() const { return passes_.back().line.back(); }
    /// `turn`: the line is the next row of the same cell.
    void rake(Polyline line, Polyline way, bool turn) {
        const bool joined =
            begun() && (options_.one_stroke || (turn && way.empty() && free_turn(line.front())));
        if (!joined) {
            passes_.push_back({std::move(way), std::move(line)});
            return;
        }
        Polyline& last = passes_.back().line;
        last.insert(last.end(), way.begin(), way.end());
        last.insert(last.end(), line.begin(), line.end());
    }
    /// With their turns rounded, as far as there is room between two lines.
    std::vector<Pass> passes() && {
        const double radius = std::min(options_.turn_radius, options_.spacing / 2);
        for (Pass& pass : passes_)
            if (pass.line.size() > 3) pass.line = rounded(pass.line, radius);
        return std::move(passes_);
    }

  private:
    /// Whether the rake may stay down straight to `to`.
    bool free_turn(Point to) const {
        if (!options_.rake_turns || distance(here(), to) >= turn_reach * options_.spacing) return false;
        const auto crossed = [&](const Polygon& polygon) {
            for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
                if (crossing(here(), to, polygon[j], polygon[i])) return true;
            return false;
        };
        return std::ranges::none_of(floor_, [&](const Region& part) {
            return crossed(part.outer) || std::ranges::any_of(part.holes, crossed);
        });
    }
    const Options& options_;
    Regions floor_;
    std::vector<Pass> passes_;
};

/// Where a way begins and ends is said by the passes.
Polyline corners_of(Polyline way) {
    if (way.size() <= 2) return {};
    return {way.begin() + 1, way.end() - 1};
}

Polyline way_between(Router& router, int from, int to) {
    router.start(from);
    while (const auto reached = router.next())
        if (reached->stop == to) return router.way_to(to);
    return {};
}

/// Whether a line ends at raked sand beside its own cell: the way to the next line must keep off it.
bool beside_raked(const Plan& plan, int line, bool right) {
    return std::ranges::any_of(plan.corridors.stops[plan.ends_of[line][right]].links, [&](int other) {
        const int corridor = plan.corridors.stops[other].corridor;
        return plan.corridors.of[corridor].raked && plan.unit_of[corridor] != plan.unit_of[line];
    });
}

/// The lines of a cell, back and forth.
void rake_cell(Plan& plan, const Entry& entry, Router& router, const Options& options, Drive& drive) {
    std::vector<int> lines = plan.units[entry.unit].corridors;
    if (entry.from_top) std::ranges::reverse(lines);
    bool from_right = entry.from_right;
    Polyline way = corners_of(entry.way);
    for (std::size_t i = 0; i < lines.size(); ++i, from_right = !from_right) {
        const Line& line = *plan.line_of[lines[i]];
        bool turn = false;
        if (i > 0) {
            const Line& last = *plan.line_of[lines[i - 1]];
            turn = std::abs(last.row - line.row) == 1 && overlap(last, line);
            if (turn) {
                // Where the next line begins far back along the raked one: over to it, then along it.
                // Where the sand beyond their ends is raked: over further in.
                const Point start = from_right ? line.right : line.left;
                const Point over = nearest_on_segment(drive.here(), line.left, line.right);
                if (beside_raked(plan, lines[i - 1], from_right) ||
                    beside_raked(plan, lines[i], from_right)) {
                    const double in = further_in * options.width;
                    const Point back =
                        normalized(from_right ? line.left - line.right : line.right - line.left);
                    const double longer = dot(start - drive.here(), back);
                    const Point turn_off = drive.here() + (in + std::max(0.0, longer)) * back;
                    way = {nearest_on_segment(turn_off, last.left, last.right),
                           nearest_on_segment(turn_off, line.left, line.right)};
                } else if (distance(over, start) > leap * options.width) {
                    way = {over};
                }
            } else {
                way = corners_of(way_between(router, plan.ends_of[lines[i - 1]][from_right],
                                             plan.ends_of[lines[i]][from_right]));
            }
        }
        drive.rake(from_right ? reversed(line.points) : line.points, std::exchange(way, {}), turn);
        plan.corridors.of[lines[i]].raked = true;
    }
}

/// A segment of another style: over its own sand to where its passes begin, then they as they are.
void rake_other(Plan& plan, const Entry& entry, Drive& drive) {
    const Unit& unit = plan.units[entry.unit];
    Polyline way;
    if (!entry.way.empty()) way.assign(entry.way.begin() + 1, entry.way.end());
    for (const Pass& pass : unit.other->passes)
        drive.rake(pass.line, &pass == unit.other->passes.data() ? std::move(way) : pass.way, false);
    for (int corridor : unit.corridors) plan.corridors.of[corridor].raked = true;
}

}  // namespace

std::vector<Pass> driven(Plan plan, const Regions& room, const Wish& wish, const Options& options) {
    Router router(plan.corridors);
    Drive drive(room, options);
    std::vector<bool> done(plan.units.size(), false);
    int here = -1;
    for (int left = static_cast<int>(plan.units.size()); left > 0; --left) {
        const Entry entry = next_entry(plan, done, left, here, router, wish, options);
        done[entry.unit] = true;
        const Unit& unit = plan.units[entry.unit];
        if (unit.other) {
            rake_other(plan, entry, drive);
        } else if (!unit.ring) {
            rake_cell(plan, entry, router, options, drive);
        } else {
            const int corridor = unit.corridors[0];
            const Ring& ring = plan.corridors.of[corridor].line;
            const double s = entry.stop >= 0 ? plan.corridors.stops[entry.stop].s
                             : drive.begun() ? nearest(ring, drive.here()).s
                                             : 0;
            const double radius = options.round_corners ? options.turn_radius : 0;
            const Polyline line = rounded(along(ring, s, ring.length), radius);
            Polyline way = corners_of(entry.way);
            for (Polyline& part : with_cut_corners(line, true, true, options))
                drive.rake(std::move(part), std::exchange(way, {}), false);
            plan.corridors.of[corridor].raked = true;
        }
        here = entry.end;
    }
    return std::move(drive).passes();
}

}  // namespace strandline::fill
