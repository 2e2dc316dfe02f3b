#pragma once
// Private to the room: one continuous line over rings that lie in each other or side by side.
#include "path/fill/rings.hpp"

namespace strandline::fill {

/// A ring and the sense in which it is gone round. Places on it are arc lengths u in that sense; they may go
/// beyond one turn.
struct Lane {
    const Ring* ring = nullptr;
    int sense = 1;  // -1: against the ring's own
};
Point at(const Lane& lane, double u);

/// Where the line shifts from a lane to the next: places that face each other, and the share of the way
/// across that is done there, from 0 to 1.
struct ShiftKnot {
    double a = 0, b = 0;  // on this lane, on the next
    double share = 0;
};
struct Shift {
    std::vector<ShiftKnot> knots;
    bool whole = false;  // takes the whole turn: a spiral of Archimedes
};

/// The first lanes of a chain that one seam serves, where the line shifts between them, and where it begins.
struct Revolutions {
    std::vector<Lane> lanes;
    std::vector<Shift> shifts;  // one fewer than lanes
    double begin = 0;           // on the first lane
};

/// A seam for as many rings from chain[first] on as have one in common, all closed: a line across them along
/// which neighbours are a spacing apart, straight where it can be, near `from` and, when it reaches the
/// chain's end, near `onward`. `floor`: where the rake's centre may be. O(seams x rings x corners).
Revolutions revolutions(const std::vector<const Ring*>& chain, std::size_t first, std::optional<Point> from,
                        const Ring* onward, const AreaIndex& floor, const Options& options);

/// Whether the way between two places a spacing or two apart stays on the floor, by samples.
bool sees(const AreaIndex& floor, Point a, Point b);

/// The line: each ring but for where it shifts to the next; and its last turn, which closes the last ring and
/// goes on where the rest ends.
struct TurnedLine {
    Polyline rest, last;
};
TurnedLine line_of(const Revolutions& revolutions);

}  // namespace strandline::fill
