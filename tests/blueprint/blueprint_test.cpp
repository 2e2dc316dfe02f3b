// The drawing of a machine shows what its profile says.
#include "result/blueprint/blueprint.hpp"

#include <gtest/gtest.h>

namespace strandline::blueprint {
namespace {

int count(const std::string& text, const std::string& what) {
    int n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

TEST(Blueprint, EveryPinAndWheelOfEachBuiltInRobotIsThere) {
    for (const std::string& name : builtin_robots()) {
        const Robot robot = *builtin_robot(name);
        const std::string svg = write_svg(robot);
        EXPECT_EQ(count(svg, "<circle"), robot.pins + 1) << name;  // and the turning point
        EXPECT_EQ(count(svg, "#444"), static_cast<int>(robot.wheels.size())) << name;
        EXPECT_EQ(count(svg, "stroke-dasharray"), robot.min_radius > 0 ? 2 : 0) << name;
        EXPECT_NE(svg.find(name), std::string::npos);
        EXPECT_EQ(svg.find("nan"), std::string::npos) << name;
    }
}

TEST(Blueprint, AMirroredMachineGivesTheMirroredDrawing) {
    Robot right = *builtin_robot("turf"), left = right;
    left.rake_side = -right.rake_side;
    // P keeps its height on the page, and its distance to the edge is counted from the other side.
    const auto turning_point = [](const std::string& svg) {
        const std::size_t at = svg.rfind("<circle cx=\"") + 12;
        return std::stod(svg.substr(at));
    };
    constexpr double page = 640;
    EXPECT_NEAR(turning_point(write_svg(left)), page - turning_point(write_svg(right)), 0.11);
}

TEST(Blueprint, AWideTurnDoesNotShrinkTheMachine) {
    Robot wide = *builtin_robot("beachbot");
    wide.min_radius = 10;
    const std::string near = write_svg(wide);
    wide.min_radius = 100;
    const auto wheels = [](const std::string& svg) { return svg.substr(svg.find("#444") - 80, 80); };
    EXPECT_EQ(wheels(near), wheels(write_svg(wide)));
}

TEST(Blueprint, ANameIsTextWhateverItHolds) {
    Robot robot;
    robot.name = "<b> & \"c\"";
    const std::string svg = write_svg(robot);
    EXPECT_NE(svg.find("&lt;b> &amp; &quot;c&quot;"), std::string::npos);
    EXPECT_EQ(svg.find("<b>"), std::string::npos);
}

}  // namespace
}  // namespace strandline::blueprint
