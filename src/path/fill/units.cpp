// Cells, rings and the ways between them.
#include "path/fill/units.hpp"

#include <algorithm>

namespace strandline::fill {
namespace {

// Shares of the rake's width:
constexpr double near_by = 1.15;     // a pass whose middle is no farther can be gone over to
constexpr double row_end_reach = 2;  // from a line's end to the end of the next
constexpr double stops_apart = 1;    // along the corridors of another style
constexpr double most_stops = 64;    // on each
constexpr double ridge_reach = 2.1;  // between the innermost of them

/// Lines that follow one another row by row without a choice are one cell. `first`: number of the first line.
void add_cells(const std::vector<Line>& lines, int first, const Options& options, Plan& plan) {
    const auto add = [&](int line) {
        plan.units.push_back({{line}, false, false});
        plan.unit_of[line] = static_cast<int>(plan.units.size()) - 1;
    };
    const auto n = static_cast<int>(lines.size());
    std::vector<int> ups(n, 0), downs(n, 0), below(n, -1);
    for (int i = 0, start = 0; i < n; ++i) {
        while (lines[start].row < lines[i].row - 1) ++start;
        for (int k = start; k < i && lines[k].row < lines[i].row; ++k)
            if (overlap(lines[k], lines[i])) ++ups[k], ++downs[i], below[i] = k;
    }
    for (int i = 0; i < n; ++i) {
        const bool goes_on =
            options.partition == Partition::none ? i > 0 : downs[i] == 1 && ups[below[i]] == 1;
        if (!goes_on) {
            add(first + i);
            continue;
        }
        const int unit = plan.unit_of[first + (options.partition == Partition::none ? i - 1 : below[i])];
        plan.units[unit].corridors.push_back(first + i);
        plan.unit_of[first + i] = unit;
    }
}

void connect(Plan& plan, int stop, int other) {
    link(plan.corridors, stop, other);
    const int a = plan.unit_of[plan.corridors.stops[stop].corridor];
    const int b = plan.unit_of[plan.corridors.stops[other].corridor];
    if (a == b) return;
    plan.neighbours[a].push_back(b);
    plan.neighbours[b].push_back(a);
}

/// The stop of a unit that is nearest to `p`.
int nearest_stop(Plan& plan, const Unit& unit, Point p) {
    int corridor = -1;
    Foot best;
    for (int c : unit.corridors)
        if (const Foot foot = nearest(plan.corridors.of[c].line, p); foot.distance < best.distance)
            best = foot, corridor = c;
    return stop_at(plan.corridors, corridor, best.s);
}

/// Ways within a segment of another style, and over to what is beside it.
void connect_other(Plan& plan, int u, const Options& options) {
    Unit& unit = plan.units[u];
    for (int c : unit.corridors) {
        const double length = plan.corridors.of[c].line.length;
        const double parts = std::clamp(std::ceil(length / (stops_apart * options.width)), 1.0, most_stops);
        for (double i = 0; i < parts; ++i) stop_at(plan.corridors, c, i / parts * length);
        if (!plan.corridors.of[c].line.closed) stop_at(plan.corridors, c, length);
    }
    unit.first = nearest_stop(plan, unit, unit.other->passes.front().line.front());
    unit.last = nearest_stop(plan, unit, unit.other->passes.back().line.back());
    for (int c : unit.corridors) {
        const std::vector<int> stops = plan.corridors.of[c].stops;
        for (int k = 0; k < static_cast<int>(plan.corridors.of.size()); ++k) {
            const Ring& line = plan.corridors.of[k].line;
            const bool within = plan.unit_of[k] == u;
            if (k == c || (within && std::abs(line.level - plan.corridors.of[c].line.level) > 1)) continue;
            const double reach = (within ? ridge_reach : near_by) * options.width;
            for (int stop : stops) {
                const Point p = plan.corridors.stops[stop].at;
                if (!contains(grown(line.box, reach), p)) continue;
                if (const Foot foot = nearest(line, p); foot.distance <= reach)
                    connect(plan, stop, stop_at(plan.corridors, k, foot.s));
            }
        }
    }
}

}  // namespace

bool overlap(const Line& a, const Line& b) { return std::min(a.to, b.to) > std::max(a.from, b.from); }

Plan planned(const std::vector<std::vector<Line>>& segments, const std::vector<OtherFill>& others,
             const std::vector<Ring>& borders, const Regions& room, const Options& options) {
    Plan plan;
    for (const auto& lines : segments)
        for (const Line& line : lines) {
            plan.corridors.of.push_back({ring_of({line.left, line.right}, 0, false), {}, false});
            plan.line_of.push_back(&line);
        }
    const auto line_count = static_cast<int>(plan.line_of.size());
    for (const Ring& ring : borders) {
        plan.corridors.of.push_back({ring, {}, false});
        plan.line_of.push_back(nullptr);
    }
    const auto first_other = static_cast<int>(plan.line_of.size());
    for (const OtherFill& other : others)
        for (const Ring& ring : other.corridors) {
            plan.corridors.of.push_back({ring, {}, false});
            plan.line_of.push_back(nullptr);
        }
    plan.unit_of.assign(plan.corridors.of.size(), -1);
    int first = 0;
    for (const auto& lines : segments) {
        add_cells(lines, first, options, plan);
        first += static_cast<int>(lines.size());
    }
    for (int r = line_count; r < first_other; ++r) {
        const bool outermost = std::ranges::any_of(room, [&](const Region& part) {
            return contains(grown(plan.corridors.of[r].line.box, 1e-9), bounds(part).low) &&
                   contains(grown(plan.corridors.of[r].line.box, 1e-9), bounds(part).high);
        });
        plan.unit_of[r] = static_cast<int>(plan.units.size());
        plan.units.push_back({{r}, true, outermost});
    }
    const auto first_other_unit = static_cast<int>(plan.units.size());
    for (int next = first_other; const OtherFill& other : others) {
        Unit unit{{}, false, false, &other};
        for (std::size_t i = 0; i < other.corridors.size(); ++i) {
            plan.unit_of[next] = static_cast<int>(plan.units.size());
            unit.corridors.push_back(next++);
        }
        plan.units.push_back(std::move(unit));
    }
    plan.neighbours.resize(plan.units.size());

    const double reach = near_by * options.width;
    for (int i = 0; i < line_count; ++i) {
        const Ring& line = plan.corridors.of[i].line;
        const double in = std::min(further_in * options.width, line.length / 2);
        plan.ends_of.push_back({stop_at(plan.corridors, i, 0), stop_at(plan.corridors, i, line.length)});
        plan.near_ends_of.push_back(
            {stop_at(plan.corridors, i, in), stop_at(plan.corridors, i, line.length - in)});
    }
    const auto segment_of = [&](int corridor) {
        std::size_t segment = 0;
        for (int past = 0; segment < segments.size(); ++segment)
            if (corridor < (past += static_cast<int>(segments[segment].size()))) break;
        return segment;
    };
    for (int i = 0; i < line_count; ++i)
        for (int side : {0, 1}) {
            for (int k = 0; k < static_cast<int>(plan.corridors.of.size()); ++k) {
                const bool rows = k < line_count && segment_of(k) == segment_of(i);
                const int end = rows ? plan.near_ends_of[i][side] : plan.ends_of[i][side];
                const Point p = plan.corridors.stops[end].at;
                const Ring& other = plan.corridors.of[k].line;
                if (k == i || !contains(grown(other.box, reach), p)) continue;
                const Foot foot = nearest(other, p);
                if (foot.distance <= reach) connect(plan, end, stop_at(plan.corridors, k, foot.s));
            }
        }
    // Along slanted edges the ends of neighbouring rows are farther apart than the rows.
    for (const Unit& unit : plan.units)
        for (std::size_t i = 0; !unit.ring && !unit.other && i + 1 < unit.corridors.size(); ++i)
            for (int side : {0, 1}) {
                const int a = plan.near_ends_of[unit.corridors[i]][side];
                const int b = plan.near_ends_of[unit.corridors[i + 1]][side];
                const double apart = distance(plan.corridors.stops[a].at, plan.corridors.stops[b].at);
                if (apart > reach && apart < row_end_reach * options.width) connect(plan, a, b);
            }
    for (int u = first_other_unit; u < static_cast<int>(plan.units.size()); ++u)
        connect_other(plan, u, options);
    sort_stops(plan.corridors);
    for (auto& near : plan.neighbours) {
        std::ranges::sort(near);
        near.erase(std::ranges::unique(near).begin(), near.end());
    }
    return plan;
}

Ties ties_of(const Plan& plan, const std::vector<bool>& done) {
    const auto n = static_cast<int>(plan.units.size());
    Ties ties{std::vector<bool>(n, false), std::vector<int>(n, 0)};
    std::vector<int> order(n, -1), low(n, 0), before(n, -1), group(n, -1), sizes;
    std::vector<std::size_t> next(n, 0);
    int count = 0;
    for (int root = 0; root < n; ++root) {
        if (done[root] || order[root] >= 0) continue;
        int branches = 0;
        const int number = static_cast<int>(sizes.size());
        sizes.push_back(0);
        std::vector<int> path{root};
        order[root] = low[root] = count++;
        while (!path.empty()) {
            const int u = path.back();
            if (next[u] == 0) group[u] = number, ++sizes[number];
            if (next[u] < plan.neighbours[u].size()) {
                const int v = plan.neighbours[u][next[u]++];
                if (done[v]) continue;
                if (order[v] < 0) {
                    order[v] = low[v] = count++;
                    before[v] = u;
                    path.push_back(v);
                } else if (v != before[u]) {
                    low[u] = std::min(low[u], order[v]);
                }
                continue;
            }
            if (next[u] == 0) ++next[u];
            path.pop_back();
            const int parent = before[u];
            if (parent < 0) continue;
            low[parent] = std::min(low[parent], low[u]);
            if (parent == root)
                ++branches;
            else if (low[u] >= order[parent])
                ties.needed[parent] = true;
        }
        ties.needed[root] = branches > 1;
    }
    for (int u = 0; u < n; ++u)
        if (group[u] >= 0) ties.group_size[u] = sizes[group[u]];
    return ties;
}

}  // namespace strandline::fill
