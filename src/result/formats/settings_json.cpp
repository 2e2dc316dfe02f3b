// The table of settings as JSON, for programs and the editor.
#include <nlohmann/json.hpp>
#include <variant>

#include "result/formats/formats.hpp"

namespace strandline::formats {
namespace {

using Json = nlohmann::ordered_json;
using Kind = Setting::Kind;

/// In SI units, as plans and programs hold it.
Json json_of(const Setting& setting, Options defaults) {
    const std::string unit = setting.kind == Kind::length     ? "m"
                             : setting.kind == Kind::angle    ? "rad"
                             : setting.kind == Kind::duration ? "s"
                                                              : "";
    Json json{{"key", setting.key}, {"kind", name_of(setting.kind)}, {"unit", unit}};
    std::visit([&](const auto* value) { json["default"] = *value; }, setting.field(defaults));
    if (setting.kind == Kind::choice) {
        json["choices"] = setting.choices;
    } else if (setting.kind != Kind::flag && setting.kind != Kind::text) {
        json["low"] = setting.low;
        json["high"] = setting.high;
    }
    json["meaning"] = setting.meaning;
    return json;
}

}  // namespace

std::string write_settings_json() {
    const Options defaults;
    std::string text = "[";
    for (const Setting& setting : settings())
        text += (text.size() > 1 ? ",\n" : "\n") + json_of(setting, defaults).dump();
    return text + "\n]";
}

}  // namespace strandline::formats
