#include "answers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "input/trace/trace.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "result/formats/formats.hpp"

namespace strandline::serve {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

const char* code_of(int status) {
    switch (status) {
        case 400:
            return "malformed";
        case 401:
            return "token";
        case 403:
            return "foreign";
        case 404:
            return "unknown";
        case 405:
            return "method";
        case 409:
            return "stale";
        case 413:
            return "too-large";
        case 415:
            return "not-a-drawing";
        case 422:
            return "refused";
        case 503:
            return "busy";
        case 507:
            return "not-saved";
        default:
            return "failed";
    }
}

/// Values of a JSON object by key; what is wrong with it otherwise.
Outcome<Json> object_in(std::string_view body) {
    Json json = Json::parse(body, nullptr, false);
    if (json.is_discarded()) return fail("body", "is not JSON", "send a JSON object");
    if (!json.is_object()) return fail("body", "is no JSON object", "send a JSON object");
    return json;
}

Json json_of(const Error& error) {
    return {{"place", error.place}, {"reason", error.reason}, {"remedy", error.remedy}};
}

Json robots() {
    Json list = Json::array();
    for (const std::string& name : builtin_robots())
        list.push_back(Json::parse(formats::write_robot_json(*builtin_robot(name))));
    return list;
}

Json robot_field_table() {
    Json list = Json::array();
    for (const RobotField& field : robot_fields())
        list.push_back({{"name", field.name},
                        {"unit", field.unit},
                        {"meaning", field.meaning},
                        {"low", field.low},
                        {"high", field.high}});
    return list;
}

}  // namespace

Reply refusal(int status, const Error& error) {
    Json json = json_of(error);
    json["code"] = code_of(status);
    return {status, json_type, text_of({{"error", std::move(json)}})};
}

Reply json_reply(int status, std::string body) { return {status, json_type, std::move(body)}; }

std::vector<std::string> path_parts(const std::string& path) {
    std::vector<std::string> parts{""};
    for (const char c : path)
        if (c == '/')
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

std::string value_in(const std::map<std::string, std::string>& values, const std::string& key,
                     const std::string& otherwise) {
    const auto found = values.find(key);
    return found == values.end() || found->second.empty() ? otherwise : found->second;
}

Outcome<long long> revision_in(std::string_view body) {
    const auto json = object_in(body);
    if (!json) return tl::unexpected(json.error());
    const auto revision = json->find("revision");
    if (revision == json->end() || !revision->is_number_integer())
        return fail("body/revision", "is no whole number", "send the revision that is being changed");
    return revision->get<long long>();
}

Outcome<long long> revision_in_query(const Call& call) {
    const std::string text = value_in(call.query, "revision", "");
    long long revision = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), revision);
    if (text.empty() || read.ptr != text.data() + text.size())
        return fail("query/revision", "is no whole number", "send the revision that is being changed");
    return revision;
}

Outcome<Lettering> lettering_in(std::string_view body) {
    const auto json = object_in(body);
    if (!json) return tl::unexpected(json.error());
    Lettering wanted;
    const auto text = [&](const char* key, std::string& value) {
        const auto found = json->find(key);
        if (found == json->end()) return true;
        if (found->is_string()) value = found->get<std::string>();
        return found->is_string();
    };
    if (!text("text", wanted.text) || !text("font", wanted.font) || !text("align", wanted.align))
        return fail("body", "text, font and align are texts");
    if (const auto height = json->find("height"); height != json->end()) {
        if (!height->is_number()) return fail("body/height", "is no number", "send metres");
        wanted.height = height->get<double>();
    }
    return wanted;
}

bool is_project_text(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '{';
}

Outcome<void> is_drawing(const SourceFile& file) {
    const auto refused = [&](Error error) {
        error.place = error.place.empty() ? file.title : file.title + ", " + error.place;
        return tl::unexpected(std::move(error));
    };
    if (!trace::format_of(file.bytes).empty()) {
        const auto picture = trace::read_picture(file.bytes);
        return picture ? Outcome<void>() : refused(picture.error());
    }
    const bool svg =
        file.bytes.find("<svg") != std::string::npos || file.bytes.find(":svg") != std::string::npos;
    if (!svg)
        return fail(file.title, "is neither SVG nor PNG nor JPEG, nor a project", "choose a drawing's file");
    const auto document = read_source({file.bytes, file.title}, {});
    if (!document) return refused(document.error());
    if (document->shapes.empty())
        return fail(file.title, "holds no shapes: there is nothing to draw",
                    "choose another file, or begin a new sketch");
    return {};
}

std::string about_text(const Setup& setup) {
    Json fonts = Json::array(), exports = Json::array();
    for (const FontName& font : setup.fonts) fonts.push_back({{"name", font.name}, {"what", font.what}});
    for (const Exporter& exporter : setup.exporters)
        exports.push_back({{"name", exporter.name}, {"what", exporter.what}, {"suffix", exporter.suffix}});
    return text_of({{"program", setup.program},
                    {"api", 1},
                    {"settings", Json::parse(formats::write_settings_json())},
                    {"robots", robots()},
                    {"robot_fields", robot_field_table()},
                    {"fonts", std::move(fonts)},
                    {"exports", std::move(exports)},
                    {"largest_upload", largest_upload}});
}

std::string list_text(const std::vector<std::string>& ids) {
    Json list = Json::array();
    for (const std::string& id : ids) list.push_back({{"id", id}});
    return text_of({{"projects", std::move(list)}});
}

std::string id_text(const std::string& id) { return text_of({{"id", id}}); }

std::string standing_text(const Workspace& workspace) {
    const Standing now = workspace.standing();
    Json values = Json::object(), set = Json::array(), plan;
    for (const Setting& setting : settings()) values[setting.key] = get(now.state.options, setting.key);
    for (const auto& [key, value] : now.state.settings) set.push_back(key);
    if (now.planned)
        plan = {{"revision", now.planned->revision},
                {"drawing", now.planned->drawing.tag},
                {"drive", now.planned->drive.tag},
                {"samples", now.planned->samples->tag},
                {"report", now.planned->report.tag}};
    const auto steps = [](const std::vector<std::string>& names) {
        return Json{{"count", names.size()}, {"next", names.empty() ? "" : names.back()}};
    };
    return text_of({{"id", workspace.id()},
                    {"title", now.title},
                    {"revision", now.revision},
                    {"news", now.news},
                    {"source", now.state.source ? now.state.source->title : ""},
                    {"bare", is_bare(now.state)},
                    {"robot_name", now.state.robot_name},
                    {"robot", Json::parse(formats::write_robot_json(now.state.robot))},
                    {"settings", std::move(values)},
                    {"set", std::move(set)},
                    {"edits", Json::parse(formats::write_edits(now.state.edits))},
                    {"undo", steps(now.undo)},
                    {"redo", steps(now.redo)},
                    {"planning", now.planning},
                    {"failure", now.failure ? json_of(*now.failure) : Json()},
                    {"plan", std::move(plan)}});
}

std::string lettered_text(const svg::Document& document) {
    const double metres = document.size_metres && document.view.width() > 0
                              ? document.size_metres->x / document.view.width()
                              : 1e-3;
    const Affine flip{metres, 0, 0, -metres, -metres * document.view.low.x, metres * document.view.high.y};
    DrawEdit lines{"text", {}, 1, 0};
    for (const svg::Shape& shape : document.shapes)
        for (const Path& path : shape.subpaths) lines.paths.push_back(transformed(path, flip));
    Json json = Json::parse(formats::write_edits({lines})).front();
    Json warnings = Json::array();
    for (const Warning& warning : document.warnings)
        warnings.push_back({{"place", warning.place}, {"reason", warning.reason}});
    return text_of({{"paths", std::move(json["paths"])},
                    {"width", metres * document.view.width()},
                    {"height", metres * document.view.height()},
                    {"warnings", std::move(warnings)}});
}

Reply export_reply(const Exporter& exporter, const Standing& standing, const std::string& id) {
    if (standing.failure) return refusal(422, *standing.failure);
    if (standing.planning || !standing.planned)
        return refusal(409, {"plan", "is still being made", "wait a moment, then export it again"});
    const auto exported = exporter.write(*standing.planned->plan);
    if (!exported) return refusal(422, exported.error());
    Reply reply{200,
                exporter.type,
                exported->bytes,
                {{"Content-Disposition", fmt::format("attachment; filename=\"{}{}\"", id, exporter.suffix)}}};
    std::string said;
    for (const Warning& warning : exported->warnings) said += (said.empty() ? "" : " | ") + sentence(warning);
    std::ranges::replace_if(
        said, [](char c) { return c < ' ' || c > '~'; }, '?');  // a header is one line
    if (!said.empty()) reply.headers["Strandline-Warnings"] = said;
    return reply;
}

}  // namespace strandline::serve
