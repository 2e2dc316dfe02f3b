#pragma once
// Private to the room: areas that are being raked. What is finished stands in Finished's grounds.
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "math/raster/raster.hpp"
#include "path/order/order.hpp"

namespace strandline::order {

/// What a curve rolls over of strokes whose group is not finished.
struct Rolled {
    double metres = 0;  ///< with a wheel on what is raked of an area
    int crossings = 0;  ///< of a line by the turning point, to a cell
    std::optional<Point> first = {};
};

/// What strokes have raked, as cells, until their area or line is finished: a loop may roll over what its own
/// stroke has drawn.
class Raked {
  public:
    Raked(const Job& job, const Robot& robot, const Avoid& avoid);
    /// A leg rake down. `what`: names the stroke, and the way it is gone.
    void draw(const Leg& leg, const Stroke& stroke, std::uint64_t what);
    void finish(int element);
    /// O(length / cell).
    Rolled rolled(const Curve& curve) const;
    /// The same for the same strokes raked, in whatever order.
    std::uint64_t state() const { return state_; }

  private:
    struct Element {
        std::uint64_t share = 0;  ///< of the state
        std::vector<std::size_t> cells;
    };
    /// By cell: the element that raked it last, + 1.
    using Layer = std::vector<int>;
    bool is_on(const Layer& layer, Point at) const;

    const Robot& robot_;
    Raster raster_;
    Layer lines_, areas_;
    std::map<int, Element> elements_;  ///< those that are being raked
    std::uint64_t state_ = 0;
};

}  // namespace strandline::order
