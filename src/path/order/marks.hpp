#pragma once
// Private to the room: what lies in the sand when all is drawn, so that a curve can be asked what it would
// spoil.
#include <limits>
#include <span>
#include <vector>

#include "math/raster/raster.hpp"
#include "path/order/order.hpp"

namespace strandline::order {

/// What a curve drives over of one group.
struct Touch {
    int group;
    int crossings = 0;  ///< of its line
    double metres = 0;  ///< within its area and nearer to it than the clearance, to a cell
    double first_crossing = std::numeric_limits<double>::infinity();  ///< metres along the curve, to a step
};
struct Touched {
    std::vector<Touch> groups;  ///< ascending
    double hard =
        0;  ///< metres in keep-outs and outside the field, or nearer than any side of the robot, to a cell
};

/// Lines as chords by squares of a grid, areas (grown by the clearance, less a cell) as cells. Where nothing
/// finished is avoided, what is hard alone.
class Marks {
  public:
    Marks(const Job& job, const Avoid& avoid, const Robot& robot);
    /// Crossings nearer than 5 cm to the curve's ends are none, as the trace judge and
    /// check have it: a line's own end is left there. O(length / cell).
    Touched touched(const Curve& curve) const;

  private:
    struct Chord {
        Point a, b;
        int group;
    };
    /// Numbers by cell: those of cell k are items[first[k]] to before items[first[k + 1]].
    struct Cells {
        std::vector<int> first, items;
        std::span<const int> of(std::size_t cell) const {
            return std::span(items).subspan(static_cast<std::size_t>(first[cell]),
                                            static_cast<std::size_t>(first[cell + 1] - first[cell]));
        }
    };
    static Cells gathered(std::size_t cells, const std::vector<std::pair<std::size_t, int>>& entries);
    void take_lines(const Job& job, double radius);
    void take_areas(const Job& job, const Avoid& avoid, const Regions& hard);
    template <class What>
    void for_squares(Point a, Point b, What&& what) const;
    void cross(Point a, Point b, Point begin, Point end, double travelled, std::vector<Touch>& found) const;

    Raster squares_, areas_;
    std::vector<Chord> chords_;
    Cells by_square_, by_cell_;
    int hard_;                        ///< stands for what is hard among the groups of a cell
    std::optional<Box> inside_;       ///< the field's box, less what the robot's nearest side takes
    mutable std::vector<int> asked_;  ///< by chord: the last question that met it
    mutable int question_ = 0;
};

}  // namespace strandline::order
