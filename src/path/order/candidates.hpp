#pragma once
// Private to the room: the ways to go through a group that are looked at.
#include <vector>

#include "path/order/senses.hpp"

namespace strandline::order {

/// One way to go through a group: where the robot stands before and after.
struct Candidate {
    Going going;
    Pose start, end;            ///< of the robot
    Pose rake_start, rake_end;  ///< of the rake's path
    double longer = 0;          ///< metres, within the group
};

/// The step's own way first; then both directions of open lines, at most 24 nodes of closed ones in both
/// senses, all variants; what is fixed or tied is not varied. The poses are those of a robot whose rake has
/// come to rest on the curvature of the rake path's end.
std::vector<Candidate> candidates(const Job& job, const tour::Step& step, const Robot& robot);

bool is_tied(const Job& job, int group);
bool is_single(const Group& group);

}  // namespace strandline::order
