#pragma once
// Elements -> groups of strokes for the order room.
#include "path/fill/fill.hpp"
#include "path/order/order.hpp"
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// The strokes of a drawing and what filling cost.
struct Strokes {
    std::vector<order::Group> groups;
    rake::Account fills;     ///< of all areas together
    double fill_swept = 0;   ///< m^2
    std::vector<Spot> bare;  ///< gaps, by element
    int fallbacks = 0;
    Warnings warnings;
};
/// Lines are fitted with clothoids and given nodes to enter at; regions are filled. Elements that yield no
/// stroke are warned of.
Strokes strokes_of(const Drawing& drawing, const Robot& robot, const Options& options,
                   const Progress& progress);

}  // namespace strandline::pipeline
