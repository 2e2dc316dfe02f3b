// How far the robot drives over areas that are finished, by a case of hand size.
#include <gtest/gtest.h>

#include "result/check/check.hpp"

namespace strandline {
namespace {

/// A square of a metre and a line; samples a centimetre apart.
class Walk {
  public:
    Walk() {
        plan_.robot = *builtin_robot("beachbot");
        plan_.drawing.elements = {{"square", "", RegionElement{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}}},
                                  {"line", "", LineElement{path_through({{-1, 0.25}, {-1, 2}}, false), 1}}};
        plan_.strokes.resize(2);
        plan_.strokes[0].element = 0;
        plan_.strokes[1].element = 1;
    }
    Walk& go(Point to, Motion motion, int stroke = -1) {
        const Point from = at_;
        const int steps = static_cast<int>(std::lround(distance(from, to) / 0.01));
        for (int i = 0; i < steps; ++i) {
            Sample s;
            s.pose = {between(from, to, static_cast<double>(i) / steps), heading(to - from)};
            s.t = 0.1 * static_cast<double>(plan_.samples.size());
            s.motion = motion;
            s.stroke = stroke;
            plan_.samples.push_back(s);
        }
        at_ = to;
        return *this;
    }
    double over_finished() {
        Plan plan = plan_;
        Sample last;
        last.pose.at = at_;
        last.t = 0.1 * static_cast<double>(plan.samples.size());
        plan.samples.push_back(last);
        return check::prove(plan).over_finished;
    }

  private:
    Plan plan_;
    Point at_{-1, 0.5};
};

TEST(Finished, WhatIsDrivenOverBeforeItIsDrawnAndTheWayOutDoNotCount) {
    Walk walk;
    walk.go({2, 0.5}, Motion::connect).go({0.2, 0.5}, Motion::connect);  // 1.8 m of it over the bare square
    walk.go({0.8, 0.5}, Motion::draw, 0).go({2, 0.5}, Motion::connect);
    EXPECT_EQ(walk.over_finished(), 0);
}

TEST(Finished, EveryMetreAfterwardsDoesWhetherConnectionOrLead) {
    Walk walk;
    walk.go({0.2, 0.5}, Motion::connect).go({0.8, 0.5}, Motion::draw, 0).go({2, 0.5}, Motion::connect);
    walk.go({2, 0.25}, Motion::connect).go({-1, 0.25}, Motion::lead);
    EXPECT_NEAR(walk.over_finished(), 1, 0.011);
    walk.go({-1, 2}, Motion::draw, 1).go({-1, 0.75}, Motion::connect).go({0.5, 0.75}, Motion::connect);
    EXPECT_NEAR(walk.over_finished(), 1.5, 0.011);
}

TEST(Finished, DrawingAcrossIsNotDrivingBetweenStrokes) {
    Walk walk;
    walk.go({0.2, 0.5}, Motion::connect).go({0.8, 0.5}, Motion::draw, 0).go({2, 0.5}, Motion::connect);
    walk.go({-1, 0.5}, Motion::draw, 1);
    EXPECT_EQ(walk.over_finished(), 0);
}

}  // namespace
}  // namespace strandline
