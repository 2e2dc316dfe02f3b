// What there is: settings, robots, formats, fonts; and words as a drawing.
#include <pybind11/stl.h>

#include "calls.hpp"
#include "cli/export_formats.hpp"
#include "cli/fonts.hpp"
#include "result/formats/formats.hpp"

namespace strandline::python {
namespace {

std::vector<std::tuple<std::string, std::string, std::vector<std::string>>> formats_list() {
    std::vector<std::tuple<std::string, std::string, std::vector<std::string>>> all;
    for (const exports::Format& f : cli::export_formats()) all.emplace_back(f.name, f.what, f.suffixes);
    return all;
}

std::vector<std::pair<std::string, std::string>> fonts_list() {
    std::vector<std::pair<std::string, std::string>> all;
    for (const cli::FontEntry& font : value(cli::installed_fonts())) all.emplace_back(font.name, font.what);
    return all;
}

py::tuple lettered(const std::string& text, const std::string& font, double height, const std::string& align,
                   double line_spacing) {
    using lettering::Align;
    if (align != "left" && align != "centre" && align != "right")
        throw Refused{{"align", "is \"" + align + "\"", "use left, centre or right"}};
    const svg::Document document = value(lettering::lettered(text, value(cli::font_named(font)),
                                                             {.height = height,
                                                              .align = align == "left"     ? Align::left
                                                                       : align == "centre" ? Align::centre
                                                                                           : Align::right,
                                                              .line_spacing = line_spacing}));
    return py::make_tuple(py::bytes(svg::write(document)), pairs_of(document.warnings));
}

}  // namespace

void add_lists(py::module_& module) {
    using py::arg;
    module.def("settings_json", &formats::write_settings_json);
    module.def("robots", &builtin_robots);
    module.def(
        "robot_json",
        [](const std::string& name, const std::optional<std::string>& profile) {
            return formats::write_robot_json(robot_of(name, profile));
        },
        arg("name"), arg("profile"));
    module.def(
        "robot_toml",
        [](const std::string& name, const std::optional<std::string>& profile) {
            return write_robot(robot_of(name, profile));
        },
        arg("name"), arg("profile"));
    module.def("formats", &formats_list);
    module.def("fonts", &fonts_list);
    module.def("lettered", &lettered, arg("text"), arg("font"), arg("height"), arg("align"),
               arg("line_spacing"));
}

}  // namespace strandline::python
