#include "result/formats/instants.hpp"

#include <algorithm>

namespace strandline::formats {

double farthest_move(const Sample& a, const Sample& b) {
    return std::max(distance(a.pose.at, b.pose.at), distance(a.rake, b.rake));
}

std::vector<Instant> instants_between(const Robot& robot, const Sample& a, const Sample& b, double parts) {
    const double chord = distance(a.pose.at, b.pose.at);
    const double turn = wrap_angle(b.pose.heading - a.pose.heading);
    const Pose end{b.pose.at, a.pose.heading + turn};
    const RobotPath path{{0, a.pose, a.curvature}, {chord, end, b.curvature}};
    std::vector<Instant> list;
    for (double k = 1; k < parts; ++k) {
        const Pose pose = chord > 0 ? state_at(path, chord * k / parts).pose
                                    : Pose{a.pose.at, a.pose.heading + turn * k / parts};
        list.push_back({pose, rake_at(robot, pose)});
    }
    return list;
}

}  // namespace strandline::formats
