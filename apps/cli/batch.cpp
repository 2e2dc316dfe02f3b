#include "batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/text/text.hpp"
#include "console.hpp"
#include "summary.hpp"

namespace strandline::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using State = BatchItem::State;

bool has_plan(const BatchItem& item) {
    return item.state == State::planned || item.state == State::up_to_date;
}

std::size_t count_of(const std::vector<BatchItem>& items, State what) {
    return static_cast<std::size_t>(std::ranges::count(items, what, &BatchItem::state));
}

const char* name_of(State state) {
    switch (state) {
        case State::waiting:
            return "not begun";
        case State::planned:
            return "planned";
        case State::up_to_date:
            return "up to date";
        case State::failed:
            return "failed";
        case State::stopped:
            return "stopped";
    }
    return "";
}

std::string table_text(const BatchItem& item) {
    const bool faulty = has_plan(item) && item.figures.faults > 0;
    return name_of(item.state) + (faulty ? ", " + counted(item.figures.faults, "fault") : "");
}

}  // namespace

Outcome<std::vector<BatchItem>> batch_items(const std::vector<std::string>& inputs,
                                            const std::string& folder) {
    std::vector<BatchItem> items;
    std::map<std::string, std::string> taken;  // plan -> drawing
    for (const std::string& input : inputs) {
        if (input == "-") return fail("-", "has no name for its plan", "plan it alone, with -o");
        const fs::path name = fs::path(input).filename().replace_extension(".json");
        const std::string output = (fs::path(folder) / name).string();
        if (const auto [there, is_new] = taken.emplace(output, input); !is_new)
            return fail(output, "would be the plan of both " + there->second + " and " + input,
                        "rename one, or plan them into two folders");
        if (same_file(input, output)) return fail(output, "is a drawing itself", "choose another --out-dir");
        items.emplace_back().input = input;
        items.back().output = output;
    }
    return items;
}

std::string outcome_text(const BatchItem& item) {
    if (!has_plan(item)) return name_of(item.state);
    return fmt::format("{}; {}, {:.2f} m, {}", table_text(item), counted(item.figures.elements, "element"),
                       item.figures.drawn, duration(item.figures.time));
}

std::string batch_table(const std::vector<BatchItem>& items) {
    std::size_t width = 4;
    for (const BatchItem& item : items) width = std::max(width, item.input.size());
    const auto row = [&](const std::string& file, const std::string& elements, const std::string& metres,
                         const std::string& time, const std::string& warnings, const std::string& outcome) {
        return fmt::format("  {:<{}}  {:>8}  {:>9}  {:>12}  {:>8}  {}\n", file, width, elements, metres, time,
                           warnings, outcome);
    };
    std::string text = row("file", "elements", "metres", "time", "warnings", "outcome");
    BatchFigures sum;
    for (const BatchItem& item : items) {
        const BatchFigures& f = item.figures;
        text += has_plan(item) ? row(item.input, std::to_string(f.elements), fmt::format("{:.2f}", f.drawn),
                                     duration(f.time), std::to_string(f.warnings), table_text(item))
                               : row(item.input, "-", "-", "-", "-", name_of(item.state));
        sum.elements += f.elements;
        sum.drawn += f.drawn;
        sum.time += f.time;
        sum.warnings += f.warnings;
    }
    std::string outcomes;
    for (const State what :
         {State::planned, State::up_to_date, State::failed, State::stopped, State::waiting})
        if (const std::size_t n = count_of(items, what); n > 0)
            outcomes += fmt::format("{}{} {}", outcomes.empty() ? "" : ", ", n, name_of(what));
    return text + row("in all", std::to_string(sum.elements), fmt::format("{:.2f}", sum.drawn),
                      duration(sum.time), std::to_string(sum.warnings), outcomes);
}

std::string batch_json(const std::vector<BatchItem>& items) {
    std::string text = "{\"files\":[";
    for (const BatchItem& item : items) {
        Json json = {{"file", item.input}, {"plan", nullptr}, {"outcome", name_of(item.state)}};
        if (has_plan(item)) {
            json["plan"] = item.output;
            json["elements"] = item.figures.elements;
            json["drawn"] = item.figures.drawn;
            json["time"] = item.figures.time;
            json["warnings"] = item.figures.warnings;
            json["faults"] = item.figures.faults;
        }
        if (item.state == State::failed)
            json["error"] = {
                {"place", item.error.place}, {"reason", item.error.reason}, {"remedy", item.error.remedy}};
        text += (&item == items.data() ? "\n" : ",\n") +
                json.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    return text + fmt::format(
                      "\n],\"planned\":{},\"up_to_date\":{},\"failed\":{},\"stopped\":{},"
                      "\"not_begun\":{}}}\n",
                      count_of(items, State::planned), count_of(items, State::up_to_date),
                      count_of(items, State::failed), count_of(items, State::stopped),
                      count_of(items, State::waiting));
}

}  // namespace strandline::cli
