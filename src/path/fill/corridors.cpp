#include "path/fill/corridors.hpp"

#include <algorithm>

namespace strandline::fill {
namespace {
constexpr double same_stop = 1e-6;  // metres
constexpr double raked_cost = 30;   // times the length, over raked sand
}  // namespace

int stop_at(Corridors& corridors, int a, double s) {
    Corridor& corridor = corridors.of[a];
    for (int stop : corridor.stops)
        if (std::abs(corridors.stops[stop].s - s) < same_stop) return stop;
    const int stop = static_cast<int>(corridors.stops.size());
    corridors.stops.push_back({at(corridor.line, s), a, s, {}});
    corridor.stops.push_back(stop);
    return stop;
}

void link(Corridors& corridors, int stop, int other) {
    corridors.stops[stop].links.push_back(other);
    corridors.stops[other].links.push_back(stop);
}

void sort_stops(Corridors& corridors) {
    for (Corridor& corridor : corridors.of)
        std::ranges::sort(corridor.stops, {}, [&](int stop) { return corridors.stops[stop].s; });
}

void Router::offer(int stop, int before, double cost) {
    Seen& seen = seen_[stop];
    if (seen.run == run_ && (seen.settled || seen.cost <= cost)) return;
    seen = {run_, before, false, cost};
    queue_.emplace_back(cost, stop);
    std::ranges::push_heap(queue_, std::greater{});
}

void Router::start(int stop) {
    ++run_;
    queue_.clear();
    offer(stop, -1, 0);
}

std::optional<Router::Reached> Router::next() {
    while (!queue_.empty()) {
        std::ranges::pop_heap(queue_, std::greater{});
        const auto [cost, stop] = queue_.back();
        queue_.pop_back();
        if (seen_[stop].settled) continue;
        seen_[stop].settled = true;
        const Stop& here = corridors_.stops[stop];
        for (int other : here.links) {
            const Stop& there = corridors_.stops[other];
            const double factor = corridors_.of[there.corridor].raked ? raked_cost : 1;
            offer(other, stop, cost + factor * distance(here.at, there.at));
        }
        const Corridor& corridor = corridors_.of[here.corridor];
        const auto place = std::ranges::lower_bound(corridor.stops, here.s, {},
                                                    [&](int s) { return corridors_.stops[s].s; }) -
                           corridor.stops.begin();
        const auto n = static_cast<std::ptrdiff_t>(corridor.stops.size());
        for (std::ptrdiff_t step : {-1, 1}) {
            std::ptrdiff_t to = place + step;
            if (corridor.line.closed)
                to = (to + n) % n;
            else if (to < 0 || to >= n)
                continue;
            const int other = corridor.stops[to];
            if (other == stop) continue;
            double span = std::abs(corridors_.stops[other].s - here.s);
            if (corridor.line.closed && (to == place + step) == false) span = corridor.line.length - span;
            offer(other, stop, cost + (corridor.raked ? raked_cost : 1) * span);
        }
        return Reached{stop, cost};
    }
    return std::nullopt;
}

Polyline Router::way_to(int stop) const {
    Polyline way{corridors_.stops[stop].at};
    for (int before = seen_[stop].before; before >= 0; stop = before, before = seen_[stop].before) {
        const Stop &from = corridors_.stops[stop], &to = corridors_.stops[before];
        if (from.corridor == to.corridor) {
            const Ring& line = corridors_.of[from.corridor].line;
            double span = to.s - from.s;
            if (line.closed && std::abs(span) > line.length / 2) span -= std::copysign(line.length, span);
            const Polyline part = along(line, from.s, span);
            way.insert(way.end(), part.begin(), part.end());
        }
        way.push_back(to.at);
    }
    return without_duplicates(reversed(way), same_stop);
}

}  // namespace strandline::fill
