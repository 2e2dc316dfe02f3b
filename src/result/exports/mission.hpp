#pragma once
// Private to the room: a plan as items of a MAVLink mission, for every file that holds one.
#include <array>
#include <optional>

#include "result/exports/spans.hpp"

namespace strandline::exports {

/// MAV_CMD numbers (mavlink.io, common message set).
enum class Command {
    waypoint = 16,
    loiter_unlimited = 17,
    change_speed = 178,
    set_servo = 183,
    set_reverse = 194
};
/// MAV_FRAME: what a command without a place has, and heights above home.
inline constexpr int frame_mission = 2, frame_relative = 3;
/// Autopilots keep whole numbers of 1e-7 degrees.
inline constexpr int degree_decimals = 7;

struct Item {
    Command command = Command::waypoint;
    std::array<double, 4> parameters{};
    std::optional<Geographic> at;  ///< rounded to degree_decimals; absent: a command for the way to the next
    int frame() const { return at ? frame_relative : frame_mission; }
};
struct Mission {
    Site site;
    Geographic home;  ///< where the drive begins
    std::vector<Item> items;
    Warnings warnings;  ///< always: by how much the waypoints leave the path
};
/// Error: no drive; more items than the autopilot holds, however thinned within the tolerance.
Outcome<Mission> mission_of(const Plan& plan);

}  // namespace strandline::exports
