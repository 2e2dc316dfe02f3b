#pragma once
// Private to the room: the graph that arms are cut from.
// Key: a branch is a chain of edges between two nodes that are no plain joints; a trail is a chain of
// branches through junctions, in the straightest way.
#include "path/fill/passes.hpp"

namespace strandline::fill {

constexpr double parallel_sides = pi - pi / 12;  ///< the opening between sides 15 degrees apart

/// A medial axis with the angle at which the feet of a disc stand on the outline, radians: pi between
/// parallel sides, pi - a on the branch into a corner of a.
struct Axis {
    struct Edge {
        int a = 0, b = 0;
        double opening = 0;
    };
    std::vector<MedialAxis::Node> nodes;
    std::vector<Edge> edges;
};

/// A chain of nodes with its ends: what each of them rests on in the graph.
struct Trail {
    std::vector<int> nodes;
    bool cut_start = false, cut_end = false;  // ends at a junction that another trail goes through
};

/// The trails of what is a corridor: branches into corners go, one round after the other, for what they leave
/// may be a branch into a corner again. At each junction the two branches that go on the straightest become
/// one trail; the others end there.
std::vector<Trail> trails_of(const Axis& axis, double width);

}  // namespace strandline::fill
