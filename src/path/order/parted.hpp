#pragma once
// Private to the room: groups whose strokes need not be driven in one go, taken apart.
#include "path/order/order.hpp"

namespace strandline::order {

/// A job of groups in one piece each.
struct Parted {
    Job job;
    std::vector<int> group_of;  ///< by group of that job: the group of the job given
    std::vector<int> shape_of;  ///< by shape of that job: the shape of the job given
};
/// Strokes of a group that has pairs in `before`, and is tied to none, become groups of their own, those
/// together that follow each other within `near` metres; wishes for the whole hold for its parts, and its
/// area is finished with its last stroke. O(strokes + wishes for them).
Parted parted(const Job& job, double near);

/// What holds for the parts, said of the job given: variants and shapes.
void put_together(Ordered& answer, const Parted& parted, const Job& job);

}  // namespace strandline::order
