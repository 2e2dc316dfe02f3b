#include "project_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "base64.hpp"
#include "result/formats/formats.hpp"

namespace strandline::serve {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* format_name = "strandline-project";

/// Thrown and caught inside this file only.
struct Refused {
    Error error;
};
[[noreturn]] void refuse(std::string place, std::string reason) {
    throw Refused{{std::move(place), std::move(reason), "see docs/editor.md"}};
}

const Json& at(const Json& object, const char* key, const std::string& place) {
    if (!object.is_object()) refuse(place, "is no object");
    const auto found = object.find(key);
    if (found == object.end()) refuse(place, fmt::format("\"{}\" is missing", key));
    return *found;
}
std::string text_at(const Json& object, const char* key, const std::string& place) {
    const Json& value = at(object, key, place);
    if (!value.is_string()) refuse(place + "/" + key, "is no text");
    return value.get<std::string>();
}
long long whole_at(const Json& object, const char* key, const std::string& place) {
    const Json& value = at(object, key, place);
    if (!value.is_number_integer()) refuse(place + "/" + key, "is no whole number");
    return value.get<long long>();
}
const Json& list_at(const Json& object, const char* key, const std::string& place) {
    const Json& value = at(object, key, place);
    if (!value.is_array()) refuse(place + "/" + key, "is no list");
    return value;
}

Edit edit_of(const Json& json, const std::string& place) {
    auto edits = formats::read_edits(Json::array({json}).dump(), place);
    if (!edits) throw Refused{edits.error()};
    return std::move(edits->front());
}

Change change_of(const Json& json, std::size_t sources, const std::string& place) {
    if (!json.is_object()) refuse(place, "is no object");
    if (json.contains("set")) return SetChange{text_at(json, "set", place), text_at(json, "value", place)};
    if (json.contains("edit")) return EditChange{edit_of(json.at("edit"), place + "/edit")};
    if (json.contains("drop")) return DropChange{edit_of(json.at("drop"), place + "/drop")};
    if (json.contains("source")) {
        const long long source = whole_at(json, "source", place);
        if (source < 0 || static_cast<std::size_t>(source) >= sources)
            refuse(place + "/source", "there is no such drawing");
        return SourceChange{static_cast<int>(source)};
    }
    refuse(place, "is no change: it has neither set nor edit nor drop");
}

Step step_of(const Json& json, std::size_t sources, const std::string& place) {
    Step step;
    step.what = text_at(json, "what", place);
    const Json& changes = list_at(json, "changes", place);
    for (std::size_t i = 0; i < changes.size(); ++i)
        step.changes.push_back(change_of(changes[i], sources, fmt::format("{}/changes/{}", place, i)));
    return step;
}

Json json_of(const Edit& edit) { return Json::parse(formats::write_edits({edit})).front(); }

Json json_of(const Change& change) {
    if (const auto* set = std::get_if<SetChange>(&change)) return {{"set", set->key}, {"value", set->value}};
    if (const auto* added = std::get_if<EditChange>(&change)) return {{"edit", json_of(added->edit)}};
    if (const auto* dropped = std::get_if<DropChange>(&change)) return {{"drop", json_of(dropped->edit)}};
    return {{"source", std::get<SourceChange>(change).source}};
}

/// SVG is text that people may want to read there; pictures are bytes.
Json json_of(const SourceFile& source) {
    const bool text =
        source.bytes.find('\0') == std::string::npos && source.bytes.find("<svg") != std::string::npos;
    Json json{{"title", source.title}};
    if (text) try {
            json["text"] = source.bytes;
            static_cast<void>(json.dump());
            return json;
        } catch (const Json::type_error&) {  // not UTF-8
            json.erase("text");
        }
    json["base64"] = base64_of(source.bytes);
    return json;
}

SourceFile source_of(const Json& json, const std::string& place) {
    if (json.is_object() && json.contains("text"))
        return {text_at(json, "title", place), text_at(json, "text", place)};
    auto bytes = bytes_of_base64(text_at(json, "base64", place));
    if (!bytes) refuse(place + "/base64", "is not base64");
    return {text_at(json, "title", place), std::move(*bytes)};
}

Json parsed(std::string_view text, const std::string& place) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw Refused{{fmt::format("{}, byte {}", place, error.byte), "is not JSON", "send a JSON object"}};
    } catch (const Json::exception&) {  // a number too large for a double
        throw Refused{{place, "holds a number that is too large", "send finite numbers"}};
    }
}

}  // namespace

std::string write_project(const Project& project) {
    Json sources = Json::array(), steps = Json::array();
    for (const auto& source : project.sources) sources.push_back(json_of(*source));
    for (const Step& step : project.steps) {
        Json changes = Json::array();
        for (const Change& change : step.changes) changes.push_back(json_of(change));
        steps.push_back({{"what", step.what}, {"changes", std::move(changes)}});
    }
    std::string text = "{\n";
    const auto line = [&](const char* key, const std::string& value, bool last = false) {
        text += fmt::format("\"{}\": {}{}\n", key, value, last ? "" : ",");
    };
    line("format", Json(format_name).dump());
    line("version", std::to_string(Project::current_version));
    line("title", Json(project.title).dump(-1, ' ', false, Json::error_handler_t::replace));
    line("revision", std::to_string(project.revision));
    line("done", std::to_string(project.done));
    line("steps", steps.dump(-1, ' ', false, Json::error_handler_t::replace));
    line("sources", sources.dump(), true);
    return text + "}\n";
}

Outcome<Project> read_project(std::string_view text, const std::string& place) {
    try {
        const Json json = parsed(text, place);
        if (!json.is_object() || json.value("format", Json()) != format_name)
            refuse(place, "is no project of this program");
        if (json.value("version", Json()) != Project::current_version)
            refuse(place, "is a project of another version");
        Project project;
        project.title = text_at(json, "title", place);
        project.revision = whole_at(json, "revision", place);
        const Json& sources = list_at(json, "sources", place);
        for (std::size_t i = 0; i < sources.size(); ++i)
            project.sources.push_back(std::make_shared<const SourceFile>(
                source_of(sources[i], fmt::format("{}/sources/{}", place, i))));
        if (project.sources.empty()) refuse(place + "/sources", "holds no drawing");
        const Json& steps = list_at(json, "steps", place);
        for (std::size_t i = 0; i < steps.size(); ++i)
            project.steps.push_back(
                step_of(steps[i], project.sources.size(), fmt::format("{}/steps/{}", place, i)));
        const long long done = whole_at(json, "done", place);
        if (done < 0 || static_cast<std::size_t>(done) > project.steps.size())
            refuse(place + "/done", "counts steps that are not there");
        project.done = static_cast<std::size_t>(done);
        if (const auto state = state_of(project); !state) return tl::unexpected(state.error());
        return project;
    } catch (const Refused& refused) {
        return tl::unexpected(refused.error);
    }
}

Outcome<Asked> read_asked(std::string_view text, const std::string& place) {
    try {
        const Json json = parsed(text, place);
        Asked asked;
        asked.revision = whole_at(json, "revision", place);
        asked.step = step_of(json, 0, place);
        return asked;
    } catch (const Refused& refused) {
        return tl::unexpected(refused.error);
    }
}

}  // namespace strandline::serve
