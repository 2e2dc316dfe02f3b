#pragma once
// The stroke: the hinge between what to draw (before it) and how to drive (after it). Values only.
#include <memory>
#include <string>
#include <vector>

#include "machine/follow/follow.hpp"
#include "math/curve/curve.hpp"

namespace strandline {

/// A place where a stroke may be entered, or a link may be tied. `s`: arc length along the rake path.
struct Node {
    double s = 0;
    Point at;
    int drawn = -1;  ///< number of the node in the drawing's own path, -1 for one we added
    bool operator==(const Node&) const = default;
};

/// One go of the rake: down at its start, up at its end.
struct Stroke {
    int element = -1;                   ///< index in the drawing
    std::vector<Curve> rake_path = {};  ///< smooth curves end to end; corners between them
    bool closed = false;                ///< ends where it starts: may be entered at any node
    bool one_way = false;               ///< only in the direction given (fills)
    bool fill = false;                  ///< part of a region's fill: corners are rounded inside
    int pins = 1;                       ///< pins down, those in the rake's middle (pin_mask)
    /// ascending s; open strokes: both ends at least; closed: the seam not repeated
    std::vector<Node> nodes = {};
    bool operator==(const Stroke&) const = default;
};

/// Strokes that belong together and keep their order: a single line, or the fill of a region.
struct StrokeGroup {
    int element = -1;
    std::vector<Stroke> strokes;
};

/// How a stroke is gone through.
struct Entry {
    int stroke = -1;  ///< index into the plan's strokes
    int node = 0;     ///< where it is entered
    bool reversed = false;
    bool operator==(const Entry&) const = default;
};

/// The stroke's rake path as driven: a closed stroke begun (and ended) at the node, an open one at its end;
/// turned about when reversed. O(pieces).
std::vector<Curve> rake_path_from(const Stroke& stroke, int node, bool reversed);

/// The robot to drive the stroke with: its rake's centre is the middle of the stroke's pins, so that they lie
/// evenly about the rake path. Beside the machine's own by half a pitch at most. A rake at the turning point
/// cannot be driven beside its path: that robot is returned as it is.
Robot steered(const Stroke& stroke, Robot robot);

/// A piece of the robot path with one kind of motion.
struct Leg {
    Motion motion = Motion::connect;
    int stroke = -1;      ///< stroke drawn or about to be drawn; -1 for connect
    RobotPath path = {};  ///< pivot: two states at one place
    Curve curve = {};     ///< connect and loop: the exact clothoids; else empty
    bool operator==(const Leg&) const = default;
};

/// Legs end to end: of strokes that are driven in one go, or what is driven between two. The same object
/// means the same legs. Their strokes count from `stroke`.
struct Stretch {
    std::shared_ptr<const std::vector<Leg>> legs;
    int stroke = 0;
};
/// All of their legs, with the strokes of the whole drive. O(states).
std::vector<Leg> legs_of(const std::vector<Stretch>& stretches);

}  // namespace strandline
