#include <gtest/gtest.h>

#include "region/shapes.hpp"

namespace strandline {
namespace {

// Of nearly parallel edges seen from outside, the diagram has corners farther off than the area is wide by
// any factor.
TEST(MedialAxis, IsBoundedByTheAreaHoweverItIsTurned) {
    const Polygon letter{{0, 0}, {1.2, 0}, {2, 3}, {4, 3}, {4.8, 0}, {6, 0}, {3.7, 8}, {2.3, 8}};
    for (int degree = 0; degree < 180; ++degree) {
        const double a = degree * pi / 180;
        const Affine map{std::cos(a), std::sin(a), -std::sin(a), std::cos(a), 0, 0};
        for (const Region& region : inset({{shapes::moved(letter, map), {}}}, 0.31)) {
            const Box box = grown(bounds(region), 0.1);
            for (const MedialAxis::Node& node : medial_axis(region, 0.1).nodes)
                ASSERT_TRUE(contains(box, node.at)) << degree;
        }
    }
}

}  // namespace
}  // namespace strandline
