#pragma once
// Private to the room: where a lifted rake may go while some of the sand is raked: along passes that are
// still to come.
#include "path/fill/rings.hpp"

namespace strandline::fill {

/// The middle of a pass still to be raked, with the stops where others come near it, in order along it.
struct Corridor {
    Ring line;
    std::vector<int> stops;  ///< nodes
    bool raked = false;
};
struct Stop {
    Point at;
    int corridor;
    double s;                ///< arc length along it
    std::vector<int> links;  ///< stops of other corridors near by
};
struct Corridors {
    std::vector<Corridor> of;
    std::vector<Stop> stops;
};

/// Corridor `a`'s stop at arc length `s`; one that is there already is used again.
int stop_at(Corridors& corridors, int a, double s);
void link(Corridors& corridors, int stop, int other);
/// Sorts the stops along their corridors: before the first route.
void sort_stops(Corridors& corridors);

/// The cheapest way between stops, raked sand counting `raked_cost` times, Dijkstra (1959).
class Router {
  public:
    explicit Router(const Corridors& corridors) : corridors_(corridors), seen_(corridors.stops.size()) {}
    /// Goes on to the next nearest stop; absent when all that can be reached have been.
    struct Reached {
        int stop;
        double cost;
    };
    void start(int stop);
    std::optional<Reached> next();
    /// The points of the way to a stop that `next` gave, both ends among them.
    Polyline way_to(int stop) const;

  private:
    struct Seen {
        int run = 0, before = -1;
        bool settled = false;
        double cost = 0;
    };
    void offer(int stop, int before, double cost);
    const Corridors& corridors_;
    std::vector<Seen> seen_;
    std::vector<std::pair<double, int>> queue_;  // a heap, least first
    int run_ = 0;
};

}  // namespace strandline::fill
