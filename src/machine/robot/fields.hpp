#pragma once
// Private to the room: the table of robot_fields() with the member each line stands for.
#include <variant>

#include "machine/robot/robot.hpp"

namespace strandline::robot_table {

using Member = std::variant<double Robot::*, int Robot::*, bool Robot::*>;

struct Field {
    RobotField info;
    Member member;
};
const std::vector<Field>& fields();
const Field* find(std::string_view name);
/// "min_radius is 0 to 100 m: the turning point's least radius..."
std::string range_text(const RobotField& field);
/// The field as a TOML value.
std::string text_of(const Robot& robot, const Field& field);
/// Sets the field from a number (whole for counts, 0 or 1 for flags), refused outside the range. `place`
/// names text and field.
Outcome<void> assign(Robot& robot, const Field& field, double value, const std::string& place);
/// From text, with a unit where the field has one ("16cm").
Outcome<void> assign(Robot& robot, const Field& field, const std::string& text, const std::string& place);
/// Rules ask for no more pins than the robot has: for a profile whose pins changed but whose rules are its
/// base's.
void limit_rules(Robot& robot);
Error unknown_field(const std::string& name, const std::string& place);

/// Ranges of what the lists hold.
inline constexpr double max_rule_width = 1e6;  // SVG user units
inline constexpr double max_body = 10;         // metres from the turning point to any part of the robot

}  // namespace strandline::robot_table
