#pragma once
// Private to the room: the ways to go through a group that are looked at.
#include <vector>

#include "path/order/order.hpp"

namespace strandline::order {

/// How a group is gone through.
struct Going {
    tour::Step step;
    int variant = -1;  ///< of the group's; -1: its own strokes
    bool operator==(const Going&) const = default;
};
/// One way to go through a group: where the robot stands before and after.
struct Candidate {
    Going going;
    Pose start, end;            ///< of the robot
    Pose rake_start, rake_end;  ///< of the rake's path
    double longer = 0;  ///< metres within the group: rake up at its corners, and what the variant is longer
};
/// By group.
using Choices = std::vector<std::vector<Candidate>>;

/// One way through a group. The poses are those of a robot whose rake has come to rest on the curvature of
/// the rake path's end.
Candidate candidate(const Group& group, const Going& going, const Robot& robot);

/// For each group the step's own way first; then both directions of open lines, at most 24 nodes of closed
/// ones in both senses, sharp corners first, all variants; what is fixed or tied is not varied. The poses are
/// those of a robot whose rake has come to rest on the curvature of the rake path's end. A closed line that
/// has corners which the robot loops round is driven once for each of them: entered there, it saves that
/// loop.
Choices choices_of(const Job& job, const std::vector<tour::Step>& steps, const Robot& robot,
                   const Options& options);

bool is_tied(const Job& job, int group);
bool is_single(const Group& group);

}  // namespace strandline::order
