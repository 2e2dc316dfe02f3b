#pragma once
// Private to the room: connections round what is finished.
#include "path/order/pairs.hpp"
#include "path/route/route.hpp"

namespace strandline::order {

/// What is finished when a connection is driven.
struct Finished {
    route::Ground ground;      ///< areas
    std::vector<char> groups;  ///< by group
    bool any_area = false;
};
/// A connection, with what it spoils.
struct Driven {
    connect::Connection joint;
    std::vector<Pose> through = {};
    double cost = 0;  ///< metres: length, turns, blemishes
    double metres = 0;
    int crossings = 0;
};
/// The cheapest of: the connection as asked for; Dubins' words, also between poses farther on along the ends'
/// headings, as continuous curves; the way round areas. The others are looked at only where the first spoils
/// something. `tried`, if not null: all that was made, for other times.
Driven connected(const CurvatureState& from, const CurvatureState& to, const Finished& finished,
                 const Pairs& pairs, const Options& options, std::vector<Passage>* tried);

}  // namespace strandline::order
