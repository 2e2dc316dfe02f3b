#pragma once
// Strokes to drive, and the laws that every drive must keep.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "path/drive/drive.hpp"

namespace strandline::drive_tests {

inline Robot beachbot() { return *builtin_robot("beachbot"); }
inline double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}
/// Straight edges through the points.
inline Stroke polyline(const std::vector<Point>& points, bool closed = false) {
    Stroke stroke;
    stroke.closed = closed;
    double s = 0;
    const std::size_t edges = closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < edges; ++i) {
        const Point a = points[i], b = points[(i + 1) % points.size()];
        stroke.nodes.push_back({s, a, static_cast<int>(i)});
        stroke.rake_path.push_back(straight({a, heading(b - a)}, distance(a, b)));
        s += distance(a, b);
    }
    if (!closed) stroke.nodes.push_back({s, points.back(), static_cast<int>(points.size()) - 1});
    return stroke;
}
inline Stroke along(const Curve& curve, bool closed = false) {
    Stroke stroke;
    stroke.closed = closed;
    stroke.rake_path = {curve};
    stroke.nodes = {{0, curve.start.at, 0}};
    if (!closed) stroke.nodes.push_back({length(curve), end_pose(curve).at, 1});
    return stroke;
}
inline Stroke mapped(Stroke stroke, double turn, bool mirror, Point by) {
    for (Curve& curve : stroke.rake_path) {
        Point at = curve.start.at;
        double ahead = curve.start.heading;
        if (mirror) {
            at.y = -at.y;
            ahead = -ahead;
            for (Clothoid& piece : curve.pieces) piece = {piece.length, -piece.curvature, -piece.sharpness};
        }
        curve.start = {by + at.x * unit(turn) + at.y * left_normal(unit(turn)), ahead + turn};
    }
    return stroke;
}
/// Every leg rolls (its states follow from each other by their curvature) and starts where the one before it
/// ended; what is driven rake up is within 1/R. Returns the metres of rake path drawn.
inline double expect_drivable(const drive::Drive& drive, const Robot& robot) {
    double drawn = 0;
    const double limit = robot.min_radius > 0 ? 1 / robot.min_radius + 1e-9 : 1e12;
    for (std::size_t l = 0; l < drive.legs.size(); ++l) {
        const Leg& leg = drive.legs[l];
        EXPECT_GE(leg.path.size(), 2u);
        if (l > 0) {
            const RobotState &end = drive.legs[l - 1].path.back(), &start = leg.path.front();
            EXPECT_NEAR(distance(end.pose.at, start.pose.at), 0, 1e-7)
                << "leg " << l << " " << name_of(leg.motion);
            EXPECT_NEAR(end.pose.heading, start.pose.heading, 1e-7)
                << "leg " << l << " " << name_of(leg.motion);
        }
        for (std::size_t i = 1; i < leg.path.size(); ++i) {
            const RobotState &a = leg.path[i - 1], &b = leg.path[i];
            const double h = b.s - a.s;
            EXPECT_GE(h, 0);
            if (leg.motion == Motion::pivot) {
                EXPECT_EQ(a.pose.at, b.pose.at);
                continue;
            }
            if (leg.motion == Motion::loop) {
                EXPECT_LE(std::max(std::abs(a.curvature), std::abs(b.curvature)), limit);
            }
            if (leg.motion == Motion::draw) drawn += distance(rake_at(robot, a.pose), rake_at(robot, b.pose));
            const Pose rolled =
                h > 0 ? advanced(a.pose, {h, a.curvature, (b.curvature - a.curvature) / h}, h) : a.pose;
            EXPECT_NEAR(distance(rolled.at, b.pose.at), 0, 1e-6) << name_of(leg.motion);
            EXPECT_NEAR(rolled.heading, b.pose.heading, 1e-5) << name_of(leg.motion);
        }
    }
    if (!drive.legs.empty()) {
        EXPECT_LE(std::abs(drive.start.curvature), limit);
        EXPECT_LE(std::abs(drive.end.curvature), limit);
        EXPECT_EQ(drive.start.pose, drive.legs.front().path.front().pose);
        EXPECT_EQ(drive.end.pose, drive.legs.back().path.back().pose);
    }
    return drawn;
}
/// The largest distance of the lowered rake from the stroke.
inline double worst_rake_error(const drive::Drive& drive, const Robot& robot, const Stroke& stroke) {
    std::vector<Polyline> drawn;
    for (const Curve& curve : stroke.rake_path) {
        const bool line = curve.pieces.size() == 1 && curve.pieces.front().curvature == 0 &&
                          curve.pieces.front().sharpness == 0;
        drawn.emplace_back();
        for (const CurvePoint& point : sampled(curve, line ? length(curve) : 0.002))
            drawn.back().push_back(point.pose.at);
    }
    double worst = 0;
    for (const Leg& leg : drive.legs) {
        if (leg.motion != Motion::draw) continue;
        for (std::size_t i = 0; i < leg.path.size(); i += 7) {
            double nearest = 1e9;
            for (const Polyline& line : drawn)
                nearest = std::min(nearest, distance_to(line, rake_at(robot, leg.path[i].pose)));
            worst = std::max(worst, nearest);
        }
    }
    return worst;
}
inline int count(const drive::Drive& drive, Motion motion) {
    return static_cast<int>(std::count_if(drive.legs.begin(), drive.legs.end(),
                                          [&](const Leg& leg) { return leg.motion == motion; }));
}

}  // namespace strandline::drive_tests
