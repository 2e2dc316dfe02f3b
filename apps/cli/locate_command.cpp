// strandline locate: measured flags and poles -> settings.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "arguments.hpp"
#include "base/units/units.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "machine/site/site.hpp"
#include "result/exports/exports.hpp"

namespace strandline::cli {
namespace {

constexpr double degrees = 180 / pi, centimetres = 100;

std::string poles_text(const Located& found) {
    std::string text;
    for (const PlacedMarker& placed : found.markers) {
        if (!(placed.marker.radius > 0)) continue;
        text += text.empty() ? "" : "; ";
        std::string corners;
        for (const Point p : pole_outline(placed.at, placed.marker.radius))
            corners += fmt::format("{}{:.4f},{:.4f}", corners.empty() ? "" : " ", p.x, p.y);
        text += corners;
    }
    return text;
}

std::string settings_text(const Located& found, bool geographic) {
    const Site& site = found.site;
    std::string text = fmt::format("# fitted to measured markers: {:.1f} cm rms, {:.1f} cm at most\n[site]\n",
                                   centimetres * found.rms, centimetres * found.largest);
    if (geographic)
        text += fmt::format("latitude = {:.10f}\nlongitude = {:.10f}\n", site.place.latitude,
                            site.place.longitude);
    if (site.altitude != 0) text += fmt::format("altitude = {:.3f}\n", site.altitude);
    text += fmt::format("x = {:.5f}\ny = {:.5f}\nheading = \"{:.7f}deg\"\n", site.x, site.y,
                        degrees * site.heading);
    if (const std::string poles = poles_text(found); !poles.empty())
        text += fmt::format("[field]\nkeep_out = \"{}\"\n", poles);
    return text;
}

std::string json_text(const Located& found) {
    using Json = nlohmann::ordered_json;
    Json markers = Json::array();
    for (const PlacedMarker& placed : found.markers) {
        Json marker{{"name", placed.marker.name},
                    {"x", placed.at.x},
                    {"y", placed.at.y},
                    {"radius", placed.marker.radius}};
        marker["off"] = placed.off ? Json(*placed.off) : Json();
        markers.push_back(std::move(marker));
    }
    const Site& site = found.site;
    const Json json{{"site",
                     {{"latitude", site.place.latitude},
                      {"longitude", site.place.longitude},
                      {"altitude", site.altitude},
                      {"x", site.x},
                      {"y", site.y},
                      {"heading", site.heading}}},
                    {"markers", std::move(markers)},
                    {"rms", found.rms},
                    {"largest", found.largest},
                    {"scale", found.scale},
                    {"mirrored", found.mirrored}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void print_residuals(const Located& found) {
    for (const PlacedMarker& placed : found.markers)
        fmt::print(
            stderr, "{:<16} on the canvas at {:9.3f} {:9.3f} m{}{}\n", placed.marker.name, placed.at.x,
            placed.at.y, placed.off ? fmt::format(", {:.1f} cm off", centimetres * *placed.off) : "",
            placed.marker.radius > 0 ? fmt::format(", kept out of by {} m", placed.marker.radius) : "");
    fmt::print(stderr,
               "rms {:.1f} cm, at most {:.1f} cm; measured {:+.3f} % farther apart than on the canvas\n",
               centimetres * found.rms, centimetres * found.largest, 100 * (found.scale - 1));
}

}  // namespace

int locate(const LocateArguments& arguments, const Common& common) {
    const auto most = parse_length(arguments.most.empty() ? "10cm" : arguments.most, "--most");
    if (!most) return complain(most.error(), bad_call);
    Wishes wishes;
    for (const std::string& text : arguments.settings) {
        if (!text.starts_with("site."))
            return complain({"--set " + text, "is no setting of the site", "set site.latitude and the like"},
                            bad_call);
        if (const auto done = set_from_text(wishes, text); !done) return complain(done.error(), bad_call);
    }
    const auto text = read_input(arguments.input);
    if (!text) return complain(text.error(), bad_input);
    const auto markers = read_markers(*text, arguments.input);
    if (!markers) return complain(markers.error(), bad_input);
    const auto found = located(*markers, wishes.options.site.at);
    if (!found) {
        Error error = found.error();
        error.place = arguments.input + ", " + error.place;
        return complain(error, bad_input);
    }
    const bool measured_on_earth = std::holds_alternative<Geographic>(markers->front().measured);
    const bool to_stdout = arguments.output == "-";
    if (!to_stdout || !common.json)
        if (const auto written = write_output(
                arguments.output, settings_text(*found, measured_on_earth || wishes.options.site.known));
            !written)
            return complain(written.error(), bad_input);
    if (common.json) fmt::print("{}", json_text(*found));
    if (!common.quiet) print_residuals(*found);
    if (found->mirrored)
        warn({{"markers", "a mirrored canvas would fit far better: are x and y, or two names, swapped?"}},
             false);
    if (found->largest <= *most) return done;
    fmt::print(stderr, "short of --most: a marker is {:.1f} cm off, {:.1f} cm are allowed\n",
               centimetres * found->largest, centimetres * *most);
    return falls_short;
}

}  // namespace strandline::cli
