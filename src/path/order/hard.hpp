#pragma once
// Private to the room: the field's border and the keep-outs, which hold whatever else is avoided.
#include "path/order/order.hpp"
#include "path/route/route.hpp"

namespace strandline::order {

/// What a metre costs along which the footprint leaves the field or reaches into a keep-out: more than any
/// way round.
inline constexpr double hard_cost = 1000;

class Hard {
  public:
    /// `clearance`: what grounds keep from finished areas, too (add_to).
    Hard(const Job& job, const Robot& robot, double clearance, double radius);
    bool any() const { return field_ || !keep_out_.empty(); }
    /// Whether a curve from place to place by Dubins' words may come near to any of it.
    bool near(Point a, Point b) const;
    /// Metres along which the footprint leaves the field or reaches into a keep-out, to 2 cm.
    double metres(const Curve& curve) const;
    /// As obstacles that a turning point, kept off by the ground's clearance, cannot touch with the
    /// footprint, however it stands.
    void add_to(route::Ground& ground) const;
    /// Only those, and only as far from the turning point as the footprint's sides: where there is no way
    /// otherwise, or an end is nearer than its corners reach.
    const route::Ground& narrow() const { return narrow_; }

  private:
    void add(route::Ground& ground, double reach) const;
    const Robot& robot_;
    const std::optional<Region>& field_;
    const Regions& keep_out_;
    double clearance_, radius_;
    Box inner_;             ///< of a field that is a box: within it nothing comes near the border
    route::Ground surely_;  ///< where a curve is clear, the footprint is
    route::Ground narrow_;
};

}  // namespace strandline::order
