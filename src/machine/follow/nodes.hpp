#pragma once
// Private to the room: the rake path as places and steps, and the way back to it. Notation as in follow.cpp.
#include "machine/follow/follow.hpp"

namespace strandline {

/// Curvatures (1/m), headings (rad) and places (m) nearer than this are one: rounding at the joints of
/// pieces.
inline constexpr double rounding = 1e-9;

/// A place on the rake path, both sides of a corner apart.
struct RakeNode {  // not Node: that is a stroke's
    double s = 0;
    Pose rake;             ///< heading unwrapped along the path
    double curvature = 0;  ///< of the rake path, just after the node; the last node of a piece: just before
    double step = 0;       ///< to the next node; 0: a joint or a corner, the next node is at the same place
    double next_curvature = 0;  ///< at the far end of the step
};
std::vector<RakeNode> nodes_of(const std::vector<Curve>& rake_path, double step);
/// Along a node's step, 0 <= local <= step.
Pose rake_at(const RakeNode& node, double local);
double curvature_at(const RakeNode& node, double local);

/// What the robot rolls a metre of rake: dz/ds.
double rolled(const Robot& robot, double delta);

/// Where the way back met the rake path.
struct WayBack {
    std::size_t step = 0;  ///< index of the node in whose step it is
    double s = 0;
    bool rejoined = false;  ///< false: the path's start came first
};
/// From the last state of `result` (the rake on its path at arc length s, in the step of node `step`)
/// backward, until the rake is on its path again. States, rake_s, the span and the largest error go to
/// `result`; to_end grows by what the robot drives.
WayBack stray(const std::vector<RakeNode>& nodes, std::size_t step, double s, const Robot& robot,
              const FollowOptions& options, Followed& result, double& to_end);

}  // namespace strandline
