#pragma once
// Private to the room: the lines and border rings of a zigzag as units that can be raked one after another.
#include <array>

#include "path/fill/corridors.hpp"
#include "path/fill/zigzag.hpp"

namespace strandline::fill {

/// Of the rake's width, from a line's end: off the sand beyond, which may be raked.
inline constexpr double further_in = 0.3;

/// What is raked in one go: a cell (lines that follow one another row by row, Choset's boustrophedon cell), a
/// segment in another style or a border ring.
struct Unit {
    std::vector<int> corridors;  // of a cell: its lines in order; of a ring: it
    bool ring = false, outermost = false;
    const OtherFill* other = nullptr;
    int first = -1, last = -1;  // of another style: the stops where its passes begin and end
};
/// Everything that is to be raked.
struct Plan {
    Corridors corridors;
    std::vector<Unit> units;
    std::vector<int> unit_of;                      // by corridor
    std::vector<const Line*> line_of;              // by corridor; null: none
    std::vector<std::array<int, 2>> ends_of;       // stops of a line's left and right end
    std::vector<std::array<int, 2>> near_ends_of;  // and a little further in, where one goes from row to row
    std::vector<std::vector<int>> neighbours;      // of units
};

bool overlap(const Line& a, const Line& b);
/// Units, and where one can go over from one to another. Lines and other fills are pointed to: they must
/// outlive the plan. O(lines^2).
Plan planned(const std::vector<std::vector<Line>>& segments, const std::vector<OtherFill>& others,
             const std::vector<Ring>& borders, const Regions& room, const Options& options);

/// Of each unit: whether the others hang together without it, and how many hang together with it. Tarjan
/// (1972), without recursion.
struct Ties {
    std::vector<bool> needed;
    std::vector<int> group_size;
};
Ties ties_of(const Plan& plan, const std::vector<bool>& done);

/// The units in an order in which the sand not yet raked stays connected, with the ways between.
std::vector<Pass> driven(Plan plan, const Regions& room, const Wish& wish, const Options& options);

}  // namespace strandline::fill
