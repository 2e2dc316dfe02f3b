#include "machine/robot/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units/units.hpp"

namespace strandline {
namespace robot_table {
namespace {

constexpr const char* flag_unit = "true/false";
constexpr const char* count_unit = "count";

// A mask is one bit a pin in an unsigned of 32 bits; one bit is kept free so that 1u << pins is defined.
constexpr int most_pins = 31;

template <class T>
T sized(const Robot& robot, T Robot::*member) {
    return robot.*member;
}

double value_of(const Robot& robot, const Field& field) {
    return std::visit([&](auto member) { return static_cast<double>(sized(robot, member)); }, field.member);
}

Error out_of_range(const RobotField& info, const std::string& given, const std::string& place) {
    return Error{place, fmt::format("{} is not a value of {}", given, info.name), range_text(info)};
}

}  // namespace

const std::vector<Field>& fields() {
    static const std::vector<Field> table{
        {{"rake_offset", "m",
          "how far the rake's centre trails the turning point; 0: the tool is at the turning point", 0, 10},
         &Robot::rake_offset},
        {{"rake_side", "m", "how far the rake's centre lies left of the robot's axis; negative: right",
          -max_body, max_body},
         &Robot::rake_side},
        {{"pins", count_unit, "liftable pins, equally spaced across the travel", 1, most_pins}, &Robot::pins},
        {{"pin_pitch", "m", "between neighbouring pins; a pin's groove is as wide", 1e-5, 2},
         &Robot::pin_pitch},
        {{"min_radius", "m",
          "least radius of the turning point's path, rake up; 0: it turns on the spot freely", 0, 100},
         &Robot::min_radius},
        {{"left_radius", "m",
          "least radius of turns to the left, where larger than min_radius; 0: min_radius", 0, 100},
         &Robot::left_radius},
        {{"right_radius", "m",
          "least radius of turns to the right, where larger than min_radius; 0: min_radius", 0, 100},
         &Robot::right_radius},
        {{"sharpness", "1/m^2", "largest change of curvature per metre, rake up", 1e-4, 1e9},
         &Robot::sharpness},
        {{"can_pivot", flag_unit, "may turn on the spot", 0, 1}, &Robot::can_pivot},
        {{"can_back_up", flag_unit, "may drive backwards, rake up", 0, 1}, &Robot::can_back_up},
        {{"speed", "m/s", "rake down", 1e-4, 50}, &Robot::speed},
        {{"travel_speed", "m/s", "rake up", 1e-4, 50}, &Robot::travel_speed},
        {{"acceleration", "m/s^2", "speeding up and braking", 1e-4, 1e3}, &Robot::acceleration},
        {{"turn_rate", "rad/s", "largest change of heading per second", 1e-4, 1e4}, &Robot::turn_rate},
        {{"turn_acceleration", "rad/s^2", "largest change of the turn rate per second", 1e-4, 1e7},
         &Robot::turn_acceleration},
        {{"lift_delay", "s", "from the command until the pins are up or down", 0, 10}, &Robot::lift_delay},
        {{"lifts", flag_unit, "the tool can be lifted; false: it marks what lies between strokes too", 0, 1},
         &Robot::lifts},
        {{"setback", "m", "what the footprint keeps from a field's border that was asked for", 0, 100},
         &Robot::setback},
        {{"fix_noise", "m", "what each fix of its place errs along x and along y (simulate --noise)", 0, 10},
         &Robot::fix_noise},
        {{"front", "m", "footprint ahead of the turning point", 0, max_body}, &Robot::front},
        {{"back", "m", "footprint behind the turning point", 0, max_body}, &Robot::back},
        {{"half_width", "m", "footprint to either side of the turning point", 0, max_body},
         &Robot::half_width},
        {{"fill_wide_strokes", flag_unit,
          "a drawn stroke wider than the rake becomes a region; false: it stays one line", 0, 1},
         &Robot::fill_wide_strokes},
    };
    return table;
}

const Field* find(std::string_view name) {
    const auto& table = fields();
    const auto hit =
        std::find_if(table.begin(), table.end(), [&](const Field& field) { return field.info.name == name; });
    return hit == table.end() ? nullptr : &*hit;
}

std::string range_text(const RobotField& field) {
    if (field.unit == flag_unit) return fmt::format("{} is true or false", field.name);
    if (field.unit == count_unit)
        return fmt::format("{} is a whole number from {} to {}", field.name, field.low, field.high);
    return fmt::format("{} is {} to {} {}", field.name, field.low, field.high, field.unit);
}

std::string text_of(const Robot& robot, const Field& field) {
    if (std::holds_alternative<bool Robot::*>(field.member))
        return value_of(robot, field) != 0 ? "true" : "false";
    return number_text(value_of(robot, field));
}

Outcome<void> assign(Robot& robot, const Field& field, double value, const std::string& place) {
    const RobotField& info = field.info;
    const bool whole = info.unit == count_unit || info.unit == flag_unit;
    // written so that a NaN is refused too
    if (!(value >= info.low && value <= info.high) || (whole && value != std::floor(value)))
        return tl::unexpected(out_of_range(info, number_text(value), place));
    if (const auto* number = std::get_if<double Robot::*>(&field.member)) robot.*(*number) = value;
    if (const auto* count = std::get_if<int Robot::*>(&field.member))
        robot.*(*count) = static_cast<int>(value);
    if (const auto* flag = std::get_if<bool Robot::*>(&field.member)) robot.*(*flag) = value != 0;
    return {};
}

Outcome<void> assign(Robot& robot, const Field& field, const std::string& text, const std::string& place) {
    if (field.info.unit == flag_unit) {
        if (text == "true" || text == "on" || text == "yes" || text == "1")
            return assign(robot, field, 1.0, place);
        if (text == "false" || text == "off" || text == "no" || text == "0")
            return assign(robot, field, 0.0, place);
        return tl::unexpected(out_of_range(field.info, '"' + text + '"', place));
    }
    const auto value = field.info.unit == "m"   ? parse_length(text, place)
                       : field.info.unit == "s" ? parse_duration(text, place)
                                                : parse_number(text, place);
    if (!value) {
        Error error = value.error();
        error.remedy += (error.remedy.empty() ? "" : "; ") + range_text(field.info);
        return tl::unexpected(std::move(error));
    }
    return assign(robot, field, *value, place);
}

void limit_rules(Robot& robot) {
    for (RakeRule& rule : robot.rake_rules) rule.pins = std::min(rule.pins, robot.pins);
}

Error unknown_field(const std::string& name, const std::string& place) {
    std::string known = "name, base, wheels, rake_rules";
    for (const Field& field : fields()) known += ", " + field.info.name;
    return Error{place, fmt::format("a robot has no field \"{}\"", name), "the fields are " + known};
}

}  // namespace robot_table

using namespace robot_table;

Outcome<Robot> valid(Robot robot, const std::string& place) {
    const std::string prefix = place.empty() ? "" : place + ", ";
    for (const Field& field : fields()) {
        Robot copy = robot;
        if (const auto set = assign(copy, field, value_of(robot, field), prefix + field.info.name); !set)
            return tl::unexpected(set.error());
    }
    if (robot.name.empty()) return fail(prefix + "name", "is empty", "give the robot a name");
    if (robot.min_radius == 0 && !robot.can_pivot)
        return fail(prefix + "min_radius", "is 0, but can_pivot is false",
                    "set can_pivot = true, or a min_radius above 0");
    if (robot.rake_side != 0 && robot.rake_offset <= 0)
        return fail(prefix + "rake_side", "is not 0, but rake_offset is",
                    "a rake that lies beside the turning point must trail it too: set rake_offset above 0");
    for (const auto& [field, radius] :
         {std::pair{"left_radius", robot.left_radius}, std::pair{"right_radius", robot.right_radius}})
        if (radius != 0 && !(radius >= robot.min_radius && robot.min_radius > 0))
            return fail(prefix + field, fmt::format("{} is below min_radius, or that is 0", radius),
                        "min_radius is the smaller of the two sides' least radii, above 0");
    for (std::size_t i = 0; i < robot.wheels.size(); ++i) {
        const Wheel& wheel = robot.wheels[i];
        const std::string where = fmt::format("{}wheels[{}]", prefix, i);
        if (!(std::abs(wheel.at.x) <= max_body && std::abs(wheel.at.y) <= max_body))
            return fail(where, fmt::format("x, y = {}, {} is out of range", wheel.at.x, wheel.at.y),
                        fmt::format("x and y are {} to {} m", -max_body, max_body));
        if (!(wheel.width > 0 && wheel.width <= max_body))
            return fail(where, fmt::format("width {} is out of range", wheel.width),
                        fmt::format("width is above 0, up to {} m", max_body));
    }
    double last = -1;
    for (std::size_t i = 0; i < robot.rake_rules.size(); ++i) {
        const RakeRule& rule = robot.rake_rules[i];
        const std::string where = fmt::format("{}rake_rules[{}]", prefix, i);
        if (!(rule.up_to >= 0 && rule.up_to <= max_rule_width))
            return fail(where, fmt::format("up_to {} is out of range", rule.up_to),
                        fmt::format("up_to is 0 to {} SVG user units", max_rule_width));
        if (!(rule.up_to > last))
            return fail(where, "up_to does not grow", "write the rules from thin to wide");
        if (rule.pins < 0 || rule.pins > robot.pins)
            return fail(where, fmt::format("pins {} is out of range", rule.pins),
                        fmt::format("pins is 0 to {}, as many as the robot has", robot.pins));
        last = rule.up_to;
    }
    return robot;
}

Outcome<Robot> with_field(Robot robot, const std::string& name, const std::string& value) {
    const std::string place = "robot." + name;
    if (name == "name" || name == "base" || name == "wheels" || name == "rake_rules")
        return fail(place, "is not a single number or flag", "set it in a profile, a .toml file");
    const Field* field = find(name);
    if (!field) return tl::unexpected(unknown_field(name, place));
    if (const auto set = assign(robot, *field, value, place); !set) return tl::unexpected(set.error());
    limit_rules(robot);
    return valid(std::move(robot), "robot");
}

const std::vector<RobotField>& robot_fields() {
    static const std::vector<RobotField> names = [] {
        std::vector<RobotField> list;
        for (const Field& field : fields()) list.push_back(field.info);
        return list;
    }();
    return names;
}

}  // namespace strandline
