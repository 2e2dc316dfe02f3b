#include "batch_record.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/text/text.hpp"
#include "console.hpp"
#include "result/formats/formats.hpp"

namespace strandline::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "strandline-batch";
constexpr int current_version = 1;

std::string path_in(const std::string& folder) {
    return (std::filesystem::path(folder) / ".strandline-batch").string();
}

}  // namespace

std::string digest_of(std::string_view bytes) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return fmt::format("{:016x}", hash);
}

std::string digest_of(const Asked& asked) {
    // A program that was built anew may plan otherwise under the same version.
    const auto program = read_input("/proc/self/exe");
    std::string all = "strandline " STRANDLINE_VERSION " " + (program ? digest_of(*program) : "") + '\n';
    add(all, formats::write_robot_json(asked.robot));
    for (const Setting& setting : settings())
        add(all, fmt::format("\n{}={}", setting.key, get(asked.wishes.options, setting.key)));
    add(all, fmt::format("\n{}\n", formats::write_edits(asked.wishes.edits)));
    add_number(all, asked.most_time);
    return digest_of(all);
}

BatchRecord read_batch_record(const std::string& folder) {
    const auto text = read_input(path_in(folder));
    if (!text) return {};
    const Json file = Json::parse(*text, nullptr, false);
    BatchRecord record;
    try {
        if (file.at("format") != format_name || file.at("version") != current_version) return {};
        for (const auto& [name, entry] : file.at("plans").items())
            record[name] = {entry.at("made_from"),
                            entry.at("plan"),
                            {entry.at("elements"), entry.at("drawn"), entry.at("time"), entry.at("warnings"),
                             entry.at("faults"), entry.at("short_of")}};
    } catch (const Json::exception&) {
        return {};
    }
    return record;
}

Outcome<void> write_batch_record(const std::string& folder, const BatchRecord& record) {
    Json plans = Json::object();
    for (const auto& [name, entry] : record)
        plans[name] = {{"made_from", entry.made_from},       {"plan", entry.plan},
                       {"elements", entry.figures.elements}, {"drawn", entry.figures.drawn},
                       {"time", entry.figures.time},         {"warnings", entry.figures.warnings},
                       {"faults", entry.figures.faults},     {"short_of", entry.figures.short_of}};
    const Json file = {{"format", format_name}, {"version", current_version}, {"plans", plans}};
    return write_output(path_in(folder), file.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace strandline::cli
