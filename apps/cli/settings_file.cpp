// The only file of the program that includes toml++.
#include <fmt/format.h>
#include <toml++/toml.h>

#include "arguments.hpp"
#include "base/units/units.hpp"
#include "console.hpp"

namespace strandline::cli {
namespace {

std::string at(const std::string& path, const toml::node& node) {
    return fmt::format("{}, line {}", path, node.source().begin.line);
}

/// A scalar as the text that --set would take.
Outcome<std::string> text_of(const toml::node& node, const std::string& place) {
    if (const auto* s = node.as_string()) return s->get();
    if (const auto* b = node.as_boolean()) return std::string(b->get() ? "on" : "off");
    if (const auto* i = node.as_integer()) return fmt::format("{}", i->get());
    if (const auto* f = node.as_floating_point()) return number_text(f->get());
    if (const auto* list = node.as_array()) {
        std::string all;
        for (const toml::node& entry : *list) {
            const auto text = text_of(entry, place);
            if (!text) return text;
            all += (all.empty() ? "" : "; ") + *text;
        }
        return all;
    }
    return fail(place, "is neither a text nor a number nor true or false");
}

Outcome<void> read_edits(Wishes& wishes, const toml::node& node, const std::string& place,
                         Outcome<Edit> (*parse)(const std::string&)) {
    const toml::array* texts = node.as_array();
    if (!texts) return fail(place, "is not a list of texts", "write [\"eye:0=lid:-1\"]");
    for (const toml::node& entry : *texts) {
        const auto text = text_of(entry, place);
        if (!text) return tl::unexpected(text.error());
        const auto edit = parse(*text);
        if (!edit) return tl::unexpected(edit.error());
        wishes.edits.push_back(*edit);
    }
    return {};
}

Outcome<void> read_group(Wishes& wishes, const std::string& group, const toml::table& table,
                         const std::string& path) {
    for (const auto& [key, node] : table) {
        const auto text = text_of(node, at(path, node));
        if (!text) return tl::unexpected(text.error());
        if (group == "robot" && key.str() == "base") {
            wishes.robot = *text;
            continue;
        }
        if (group == "robot") {
            wishes.robot_fields.emplace_back(std::string(key.str()), *text);
            continue;
        }
        if (auto done = set(wishes.options, group + "." + std::string(key.str()), *text); !done) {
            done.error().place = at(path, node) + ", " + done.error().place;
            return done;
        }
    }
    return {};
}

}  // namespace

Outcome<void> read_settings_file(Wishes& wishes, const std::string& path) {
    const auto text = read_input(path);
    if (!text) return tl::unexpected(text.error());
    toml::table file;
    try {
        file = toml::parse(*text);
    } catch (const toml::parse_error& error) {
        return fail(fmt::format("{}, line {}", path, error.source().begin.line),
                    std::string(error.description()));
    }
    for (const auto& [key_name, node] : file) {
        const std::string key(key_name.str());
        Outcome<void> done;
        if (key == "link")
            done = read_edits(wishes, node, at(path, node), parse_link);
        else if (key == "entry")
            done = read_edits(wishes, node, at(path, node), parse_entry);
        else if (key == "direction")
            done = read_edits(wishes, node, at(path, node), parse_direction);
        else if (key == "robot" && node.is_string())
            wishes.robot = node.as_string()->get();
        else if (const toml::table* table = node.as_table())
            done = read_group(wishes, key, *table, path);
        else
            done = fail(at(path, node), fmt::format("\"{}\" is not a table of settings", key),
                        "write [fill] and below it spacing = \"36cm\"; strandline settings lists them");
        if (!done) return done;
    }
    return {};
}

}  // namespace strandline::cli
