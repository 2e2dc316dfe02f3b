#include "path/stroke/stroke.hpp"

#include <gtest/gtest.h>

namespace strandline {
namespace {

/// A square of side 2 from (0, 0), counter-clockwise, with a node at each corner.
Stroke square() {
    Stroke stroke;
    stroke.closed = true;
    for (int i = 0; i < 4; ++i) {
        const Pose at{apply({std::cos(i * pi / 2), std::sin(i * pi / 2), -std::sin(i * pi / 2),
                             std::cos(i * pi / 2), 1, 1},
                            {-1, -1}),
                      i * pi / 2};
        stroke.rake_path.push_back(straight(at, 2));
        stroke.nodes.push_back({2.0 * i, at.at, i});
    }
    return stroke;
}
/// A circle of one curve of two pieces, nodes at the quarters.
Stroke circle() {
    Stroke stroke;
    stroke.closed = true;
    stroke.rake_path = {{{{1, 0}, pi / 2}, {{pi, 1, 0}, {pi, 1, 0}}}};
    for (int i = 0; i < 4; ++i) stroke.nodes.push_back({i * pi / 2, unit(i * pi / 2), i});
    return stroke;
}

void expect_connected(const std::vector<Curve>& path) {
    for (std::size_t i = 1; i < path.size(); ++i)
        EXPECT_NEAR(distance(end_pose(path[i - 1]).at, path[i].start.at), 0, 1e-12);
}

TEST(Stroke, AClosedStrokeMayBeEnteredAtAnyNodeInEitherSense) {
    for (const Stroke& stroke : {square(), circle()})
        for (int node = 0; node < 4; ++node)
            for (const bool reverse : {false, true}) {
                const auto path = rake_path_from(stroke, node, reverse);
                const Point at = stroke.nodes[static_cast<std::size_t>(node)].at;
                EXPECT_NEAR(distance(path.front().start.at, at), 0, 1e-12);
                EXPECT_NEAR(distance(end_pose(path.back()).at, at), 0, 1e-12);
                EXPECT_NEAR(length(path), length(stroke.rake_path), 1e-12);
                expect_connected(path);
                // the sense: the area to the left when forward
                EXPECT_GT((reverse ? -1 : 1) * cross(unit(path.front().start.heading),
                                                     Point{stroke.rake_path.size() > 1 ? 1.0 : 0.0,
                                                           stroke.rake_path.size() > 1 ? 1.0 : 0.0} -
                                                         at),
                          0);
            }
}

TEST(Stroke, ASmoothSeamVanishesAndTheNewOneIsAtTheNode) {
    EXPECT_EQ(rake_path_from(circle(), 1, false).size(), 1u);
    EXPECT_EQ(rake_path_from(circle(), 3, true).size(), 1u);
}

TEST(Stroke, CornersStayCornersWhereverItIsEntered) {
    for (int node = 0; node < 4; ++node) EXPECT_EQ(rake_path_from(square(), node, false).size(), 4u);
    Stroke stroke = square();
    stroke.nodes[1] = {1, {1, 0}, -1};
    EXPECT_EQ(rake_path_from(stroke, 1, false).size(), 5u);
}

TEST(Stroke, AnOpenStrokeIsTurnedAboutButNeverCut) {
    Stroke stroke = square();
    stroke.closed = false;
    stroke.rake_path.pop_back();
    EXPECT_EQ(rake_path_from(stroke, 2, false), stroke.rake_path);
    const auto back = rake_path_from(stroke, 3, true);
    EXPECT_NEAR(distance(back.front().start.at, {0, 2}), 0, 1e-12);
    EXPECT_NEAR(distance(end_pose(back.back()).at, {0, 0}), 0, 1e-12);
    EXPECT_NEAR(wrap_angle(back.front().start.heading), 0, 1e-12);
}

TEST(Stroke, ANodeThatIsNotThereMeansTheSeam) {
    EXPECT_EQ(rake_path_from(square(), 9, false), square().rake_path);
    EXPECT_EQ(rake_path_from(square(), -1, false), square().rake_path);
}

}  // namespace
}  // namespace strandline
