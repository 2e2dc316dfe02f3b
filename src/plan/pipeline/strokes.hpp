#pragma once
// Elements -> groups of strokes for the order room.
#include <map>

#include "path/fill/fill.hpp"
#include "path/order/order.hpp"
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// How a group came about that is an area.
struct Filled {
    fill::Options options;
    std::vector<std::vector<Polyline>> ways;  ///< of the fill itself, then of each variant
};
/// The strokes of a drawing.
struct Strokes {
    std::vector<order::Group> groups;  ///< named by their elements
    int fallbacks = 0;
    Warnings warnings;
};
/// What the fills leave that were taken.
struct Fills {
    rake::Account account;   ///< of all areas together
    double swept = 0;        ///< m^2
    std::vector<Spot> bare;  ///< gaps, by element; largest first
};

/// What became of one element, and all that it followed from.
struct Worked {
    Element element;
    order::Group group;            ///< without strokes: nothing of it can be raked
    std::optional<Filled> filled;  ///< of an area
    fill::Fill said;               ///< what its fill says of itself: strokes and ways are in `group`
    int fallbacks = 0;
    Warnings warnings;
    std::map<int, Fills> accounts;  ///< of the variants that were taken so far
};
/// The work on each element by its id, for one robot and one set of settings: an element that is the same
/// again is not worked on again.
struct KeptStrokes {
    Robot robot;
    Options::FillArea fill;
    double tolerance = 0;
    std::map<std::string, Worked> by_id;
};

/// Lines are fitted with clothoids and given nodes to enter at; regions are filled. Elements that yield no
/// stroke are warned of.
Strokes strokes_of(const Drawing& drawing, const Robot& robot, const Options& options, KeptStrokes& kept,
                   const Progress& progress);

/// Of the groups that strokes_of() gave, with the variants taken, as Ordered has them. As dear as the fills.
Fills account_for(const std::vector<order::Group>& groups, const std::vector<int>& variants,
                  KeptStrokes& kept, const Progress& progress);

}  // namespace strandline::pipeline
