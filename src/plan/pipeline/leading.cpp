// How strokes are driven and connected, by the options; and what one connection would be if it were led
// elsewhere.
#include <cmath>
#include <string>

#include "plan/pipeline/pipeline.hpp"
#include "plan/pipeline/stages.hpp"

namespace strandline {

namespace {

constexpr double half_a_circle = pi;

/// By how much the curve turns, left and right alike, radians.
double turning(const Curve& curve) {
    double sum = 0;
    for (const Clothoid& piece : curve.pieces) {
        const double k0 = piece.curvature, k1 = piece.end_curvature();
        // Where the sign changes, both sides of it count.
        const double far = std::abs(piece.length);
        sum +=
            k0 * k1 >= 0 ? far * std::abs(k0 + k1) / 2 : far * (k0 * k0 + k1 * k1) / (2 * std::abs(k0 - k1));
    }
    return sum;
}

}  // namespace

Outcome<Leading> led_connection(const Plan& plan, int connection, const std::vector<Pose>& through) {
    if (connection < 0 || static_cast<std::size_t>(connection) >= plan.connections.size())
        return fail("connection", "there is none with number " + std::to_string(connection));
    const PlannedConnection& now = plan.connections[static_cast<std::size_t>(connection)];
    const connect::Options options = pipeline::order_options(plan.options, plan.robot).connect;
    const connect::Connection between{now.turn_before, now.turn_after, now.curve};
    const auto led = connect::led_through(between, through, options);
    if (!led) return tl::unexpected(led.error());
    // More turning than a robot without a least radius would need, from pose to pose in straight lines.
    double needed = 0;
    Pose before = now.curve.start;
    const auto go_to = [&](const Pose& pose) {
        const double chord = heading(pose.at - before.at);
        needed += std::abs(wrap_angle(chord - before.heading)) + std::abs(wrap_angle(pose.heading - chord));
        before = pose;
    };
    for (const Pose& pose : through) go_to(pose);
    go_to(end_pose(now.curve));
    return Leading{led->curve, turning(led->curve) - needed > half_a_circle};
}

}  // namespace strandline
