#pragma once
// Private to the room: connections round what is finished.
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>

#include "path/order/pairs.hpp"
#include "path/order/raked.hpp"
#include "path/route/route.hpp"

namespace strandline::order {

/// What is finished when a connection is driven.
struct Finished {
    route::Ground areas;
    route::Ground ground;      ///< those, and what is hard
    std::vector<char> groups;  ///< by group
    bool any_area = false;
    Raked raked;  ///< of what is not finished yet
};
/// What a curve drives over that it should not.
struct Spoilt {
    double metres = 0;   ///< nearer to finished areas than the clearance
    double hard = 0;     ///< metres with the footprint in a keep-out or out of the field
    Rolled rolled = {};  ///< what is not finished
    int crossings = 0;   ///< of finished lines
    double first = std::numeric_limits<double>::infinity();  ///< metres along the curve, of finished ground
    double all_metres() const { return metres + rolled.metres; }
    int all_crossings() const { return crossings + rolled.crossings; }
    bool none() const { return hard == 0 && all_metres() == 0 && all_crossings() == 0; }
};
Spoilt spoilt(const Curve& curve, const Finished& finished, const Pairs& pairs, const Options& options);
/// A connection, with what it spoils.
struct Driven {
    connect::Connection joint;
    std::vector<Pose> through = {};
    double cost = 0;  ///< metres: length, turns, blemishes
    Spoilt spoilt = {};
};
/// The cheapest of: `direct`, the connection as asked for; Dubins' words, also between poses farther on along
/// the ends' headings, as continuous curves; the way round areas and what is hard. The others are looked at
/// only where the first spoils something. `tried`: all that was made, for other times.
Driven connected(const CurvatureState& from, const CurvatureState& to, connect::Connection direct,
                 const Finished& finished, const Pairs& pairs, const Options& options,
                 std::vector<Passage>& tried);

/// Connections that were made before. The same ends, with the same finished, need not be connected again.
class Made {
  public:
    /// `direct`: what is driven where it spoils nothing; none: the connection in the style asked for.
    const Driven& connected(std::uint64_t which, const CurvatureState& from, const CurvatureState& to,
                            const Finished& finished, const Pairs& pairs, const Options& options,
                            const std::optional<connect::Connection>& direct = {});
    const std::vector<Passage>& tried(std::uint64_t which) const { return made_.at(which).tried; }

  private:
    struct One {
        CurvatureState from, to;
        connect::Connection direct;
        std::vector<char> finished;
        std::uint64_t raked = 0;
        Driven driven;
        std::vector<Passage> tried;
    };
    std::unordered_map<std::uint64_t, One> made_;
};

}  // namespace strandline::order
