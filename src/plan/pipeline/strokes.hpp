#pragma once
// Elements -> groups of strokes for the order room.
#include "path/fill/fill.hpp"
#include "path/order/order.hpp"
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// How a group came about that is an area.
struct Filled {
    fill::Options options;
    std::vector<std::vector<Polyline>> ways;  ///< of the fill itself, then of each variant
};
/// The strokes of a drawing and how areas were filled.
struct Strokes {
    std::vector<order::Group> groups;
    std::vector<std::optional<Filled>> filled;  ///< by group
    int fallbacks = 0;
    Warnings warnings;
};
/// What the fills leave that were taken.
struct Fills {
    rake::Account account;   ///< of all areas together
    double swept = 0;        ///< m^2
    std::vector<Spot> bare;  ///< gaps, by element; largest first
};
/// Lines are fitted with clothoids and given nodes to enter at; regions are filled. Elements that yield no
/// stroke are warned of.
Strokes strokes_of(const Drawing& drawing, const Robot& robot, const Options& options,
                   const Progress& progress);

/// `filled` and `variants`: by group, as Strokes and Ordered have them. As dear as the fills.
Fills account_for(const std::vector<order::Group>& groups, const std::vector<std::optional<Filled>>& filled,
                  const std::vector<int>& variants, const Drawing& drawing, const Progress& progress);

}  // namespace strandline::pipeline
