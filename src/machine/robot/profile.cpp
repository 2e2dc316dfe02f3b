// Profiles as TOML: the only file of the program that includes toml++.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>

#include "base/units/units.hpp"
#include "machine/robot/fields.hpp"

namespace strandline {
namespace {

using namespace robot_table;

/// "my.toml, line 3, pins"
std::string place_of(const std::string& text, const toml::node& node, const std::string& name) {
    return fmt::format("{}, line {}, {}", text, node.source().begin.line, name);
}

/// A number, or a text with a unit, as one double; lists hold lengths and counts only.
Outcome<double> number_in(const toml::node& node, bool is_length, const std::string& where) {
    if (const auto number = node.is_number() ? node.value<double>() : std::nullopt) {
        if (!std::isfinite(*number))
            return fail(where, "is not a finite number", "write a number such as 0.4");
        return *number;
    }
    if (const auto text = is_length ? node.value_exact<std::string>() : std::nullopt)
        return parse_length(*text, where);
    return fail(where, "is not a number",
                is_length ? "write metres (0.16) or a text with a unit (\"16cm\")" : "write a number");
}

Outcome<void> read_scalar(Robot& robot, const Field& field, const toml::node& node,
                          const std::string& where) {
    if (const auto flag = node.value_exact<bool>()) {
        if (!std::holds_alternative<bool Robot::*>(field.member))
            return fail(where, "is true or false where a number belongs", range_text(field.info));
        return assign(robot, field, *flag ? 1.0 : 0.0, where);
    }
    if (std::holds_alternative<bool Robot::*>(field.member))
        return fail(where, "is neither true nor false", range_text(field.info));
    if (const auto text = node.value_exact<std::string>()) return assign(robot, field, *text, where);
    if (const auto number = node.is_number() ? node.value<double>() : std::nullopt)
        return assign(robot, field, *number, where);
    return fail(where, "is not a number", range_text(field.info));
}

/// One entry of a list: each named number of the table, all others refused.
struct Entry {
    const char* key;
    bool is_length;
    double value;  ///< NaN: must be there
};

Outcome<void> read_entry(const toml::node& node, std::vector<Entry>& entries, const std::string& text,
                         const std::string& list) {
    const toml::table* table = node.as_table();
    std::string keys;
    for (const Entry& entry : entries) keys += (keys.empty() ? "" : ", ") + std::string(entry.key);
    if (!table)
        return fail(place_of(text, node, list), "holds something that is not a table",
                    "each entry has " + keys);
    for (const auto& [key, value] : *table) {
        const std::string where = place_of(text, value, list + "." + std::string(key.str()));
        bool known = false;
        for (Entry& entry : entries) {
            if (key.str() != entry.key) continue;
            known = true;
            const auto number = number_in(value, entry.is_length, where);
            if (!number) return tl::unexpected(number.error());
            entry.value = *number;
        }
        if (!known) return fail(where, "is not known here", "each entry has " + keys);
    }
    for (const Entry& entry : entries)
        if (std::isnan(entry.value))
            return fail(place_of(text, node, list), fmt::format("{} is missing", entry.key),
                        "each entry has " + keys);
    return {};
}

Outcome<void> read_wheels(Robot& robot, const toml::array& list, const std::string& text) {
    robot.wheels.clear();
    for (const toml::node& node : list) {
        std::vector<Entry> entries{{"x", true, NAN}, {"y", true, NAN}, {"width", true, Wheel{}.width}};
        if (const auto read = read_entry(node, entries, text, "wheels"); !read)
            return tl::unexpected(read.error());
        robot.wheels.push_back({{entries[0].value, entries[1].value}, entries[2].value});
    }
    return {};
}

Outcome<void> read_rules(Robot& robot, const toml::array& list, const std::string& text) {
    robot.rake_rules.clear();
    for (const toml::node& node : list) {
        std::vector<Entry> entries{{"up_to", false, NAN}, {"pins", false, NAN}};
        if (const auto read = read_entry(node, entries, text, "rake_rules"); !read)
            return tl::unexpected(read.error());
        const double pins = entries[1].value;
        if (pins != std::floor(pins) || std::abs(pins) > 1e6)
            return fail(place_of(text, node, "rake_rules.pins"), number_text(pins) + " is not a whole number",
                        "write 0, 1, 2, ...");
        robot.rake_rules.push_back({entries[0].value, static_cast<int>(pins)});
    }
    return {};
}

Outcome<void> read_field(Robot& robot, const std::string& key, const toml::node& node,
                         const std::string& text) {
    const std::string where = place_of(text, node, key);
    if (key == "base") return {};
    if (key == "name") {
        const auto name = node.value_exact<std::string>();
        if (!name || name->empty()) return fail(where, "is not a name", "write a text such as \"my robot\"");
        robot.name = *name;
        return {};
    }
    if (key == "wheels" || key == "rake_rules") {
        const toml::array* list = node.as_array();
        if (!list) return fail(where, "is not a list of tables", "write [[" + key + "]] above each entry");
        return key == "wheels" ? read_wheels(robot, *list, text) : read_rules(robot, *list, text);
    }
    if (const Field* field = find(key)) return read_scalar(robot, *field, node, where);
    return tl::unexpected(unknown_field(key, where));
}

/// toml++ as packaged reports a syntax error by an exception; it ends here.
Outcome<toml::table> parse(std::string_view source, const std::string& place) {
    try {
        return toml::parse(source);
    } catch (const toml::parse_error& error) {
        return fail(fmt::format("{}, line {}", place, error.source().begin.line),
                    std::string(error.description()), "write TOML: name = value, one a line");
    }
}

/// Rules are read before it is known how many pins there are.
Outcome<void> rules_within_pins(const toml::table& table, int pins, const std::string& text) {
    const toml::array* list = table["rake_rules"].as_array();
    if (!list) return {};
    for (const toml::node& rule : *list) {
        const toml::node* node = rule.as_table()->get("pins");
        const double wanted = node->value<double>().value_or(0);
        if (wanted < 0 || wanted > pins)
            return fail(place_of(text, *node, "rake_rules.pins"),
                        fmt::format("{} pins where the robot has {}", number_text(wanted), pins),
                        fmt::format("write 0 to {}; or remove every [[rake_rules]], and the base's are used, "
                                    "limited to {} pins",
                                    pins, pins));
    }
    return {};
}

std::string quoted(const std::string& name) {
    std::string text = "\"";
    for (const char c : name) {
        if (c == '"' || c == '\\') text += '\\';
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f)
            text += fmt::format("\\u{:04X}", byte);
        else
            text += c;
    }
    return text + '"';
}

}  // namespace

Outcome<Robot> read_robot(std::string_view source, const std::string& place) {
    const auto parsed = parse(source, place);
    if (!parsed) return tl::unexpected(parsed.error());
    const toml::table& table = *parsed;

    std::string base = "beachbot";
    if (const toml::node* node = table.get("base")) {
        const auto name = node->value_exact<std::string>();
        if (!name) return fail(place_of(place, *node, "base"), "is not a text", "write base = \"beachbot\"");
        base = *name;
    }
    auto robot = builtin_robot(base);
    if (!robot) {
        Error error = robot.error();
        error.place = place_of(place, *table.get("base"), "base");
        error.remedy = fmt::format("use one of {}", fmt::join(builtin_robots(), ", "));
        return tl::unexpected(std::move(error));
    }
    for (const auto& [key, node] : table)
        if (const auto read = read_field(*robot, std::string(key.str()), node, place); !read)
            return tl::unexpected(read.error());
    if (!table.contains("rake_rules")) limit_rules(*robot);
    if (const auto kept = rules_within_pins(table, robot->pins, place); !kept)
        return tl::unexpected(kept.error());
    return valid(std::move(*robot), place);
}

std::string write_robot(const Robot& robot) {
    std::string text = "name = " + quoted(robot.name) + '\n';
    for (const Field& field : fields())
        text += fmt::format("{} = {}  # {}: {}\n", field.info.name, text_of(robot, field), field.info.unit,
                            field.info.meaning);
    // an empty list is written out: without it the base's would stand
    if (robot.wheels.empty()) text += "wheels = []\n";
    if (robot.rake_rules.empty()) text += "rake_rules = []\n";
    for (const Wheel& wheel : robot.wheels)
        text += fmt::format("\n[[wheels]]\nx = {}\ny = {}\nwidth = {}\n", number_text(wheel.at.x),
                            number_text(wheel.at.y), number_text(wheel.width));
    for (const RakeRule& rule : robot.rake_rules)
        text += fmt::format("\n[[rake_rules]]\nup_to = {}\npins = {}\n", number_text(rule.up_to), rule.pins);
    return text;
}

}  // namespace strandline
