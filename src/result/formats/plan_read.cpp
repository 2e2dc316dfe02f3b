// Text to JSON, with line and column when it is none; then PlanReader and the checks.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "result/formats/formats.hpp"
#include "result/formats/plan_reader.hpp"
#include "result/formats/plan_schema.hpp"

namespace strandline::formats {
namespace {

using Json = nlohmann::json;

/// "plan.json, line 3, column 14", both from 1.
std::string place_of(std::string_view text, std::size_t offset, const std::string& place) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = 1 + std::ranges::count(before, '\n');
    const auto column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
    return fmt::format("{}{}line {}, column {}", place, place.empty() ? "" : ", ", line, column);
}

/// nlohmann's message without its own numbering and place: "[json.exception...] parse error at line 1, column
/// 2: WHAT".
std::string reason_of(const Json::exception& error) {
    std::string message = error.what();
    if (const auto at = message.find("] "); at != std::string::npos) message.erase(0, at + 2);
    if (const auto at = message.find(": "); at != std::string::npos && message.starts_with("parse error"))
        message.erase(0, at + 2);
    return message;
}

Outcome<Json> parsed(std::string_view text, const std::string& place) {
    const char* remedy = "give a file that \"strandline plan\" wrote";
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return fail(place, "the file is empty", remedy);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        return fail(place_of(text, error.byte > 0 ? error.byte - 1 : 0, place),
                    "not JSON: " + reason_of(error), remedy);
    } catch (
        const Json::exception& error) {  // a number too large for a double: named in quotes, without place
        const std::string message = reason_of(error);
        const auto open = message.find('\''), close = message.rfind('\'');
        const auto offset = open == close ? 0 : text.find(message.substr(open + 1, close - open - 1));
        return fail(place_of(text, offset, place), message, "write finite numbers");
    }
}

Outcome<void> check_version(const Json& json, const std::string& place) {
    const auto format = json.is_object() ? json.find("format") : json.end();
    if (format == json.end() || *format != plan_format_name)
        return fail(place, "JSON, but not a plan of this program",
                    "give a file that \"strandline plan\" wrote");
    const auto version = json.find("version");
    if (version == json.end() || !version->is_number_integer())
        return fail(place + " at /version", "the version is missing", "plan the drawing again");
    if (*version != Plan::current_version)
        return fail(place,
                    fmt::format("this file is version {}; this program reads {}", version->dump(),
                                Plan::current_version),
                    "plan the drawing again");
    return {};
}

}  // namespace

Outcome<std::vector<Edit>> read_edits(std::string_view text, const std::string& place) {
    const auto json = parsed(text, place);
    if (!json) return tl::unexpected(json.error());
    std::vector<Edit> edits;
    const std::optional<Flaw> flaw = take_apart(*json, edits);
    if (!flaw) return edits;
    return fail(fmt::format("{}{}", place, flaw->pointer), flaw->reason, "see docs/plan-format.md, edits");
}

Outcome<Plan> read_plan(std::string_view text, const std::string& place) {
    const auto json = parsed(text, place);
    if (!json) return tl::unexpected(json.error());
    if (const auto known = check_version(*json, place); !known) return tl::unexpected(known.error());
    Plan plan;
    std::optional<Flaw> flaw = take_apart(*json, plan);
    if (!flaw) flaw = first_flaw(plan);
    if (!flaw) return plan;
    const std::string pointer = flaw->pointer.empty() ? "the top" : flaw->pointer;
    return fail(fmt::format("{}{}{}", place, place.empty() ? "" : " at ", pointer), flaw->reason,
                "plan the drawing again");
}

}  // namespace strandline::formats
