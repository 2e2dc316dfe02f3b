// Markers as text.
#include <fmt/format.h>

#include <map>
#include <sstream>

#include "base/units/units.hpp"
#include "machine/site/site.hpp"

namespace strandline {
namespace {

constexpr auto columns =
    "the first line names the columns: name,x,y,latitude,longitude,radius or name,x,y,east,north,radius";

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line + ",");
    for (std::string cell; std::getline(in, cell, ',');) {
        const auto first = cell.find_first_not_of(" \t\r\""), last = cell.find_last_not_of(" \t\r\"");
        cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    return cells;
}

/// One line, its cells by the names of their columns.
struct Row {
    std::map<std::string, std::string> cells;
    std::string place;  ///< "flags.csv line 3"

    bool has(const std::string& name) const {
        const auto at = cells.find(name);
        return at != cells.end() && !at->second.empty();
    }
    Outcome<double> length(const std::string& name) const {
        return parse_length(cells.at(name), place + ", " + name);
    }
    Outcome<double> degrees(const std::string& name, double most) const {
        const auto value = parse_number(cells.at(name), place + ", " + name);
        if (value && !(std::abs(*value) <= most))
            return fail(place + ", " + name, fmt::format("{} is out of range", *value),
                        fmt::format("use degrees from {} to {}", -most, most));
        return value;
    }
};

Outcome<Point> point(Outcome<double> x, Outcome<double> y) {
    if (!x) return tl::unexpected(x.error());
    if (!y) return tl::unexpected(y.error());
    return Point{*x, *y};
}

Outcome<Marker> marker_of(const Row& row) {
    Marker marker;
    if (row.has("name")) marker.name = row.cells.at("name");
    const bool geographic = row.has("latitude") && row.has("longitude");
    if (!geographic && !(row.has("east") && row.has("north")))
        return fail(row.place, "does not say where the marker was measured",
                    "fill in latitude and longitude, or east and north");
    if (row.has("x") != row.has("y")) return fail(row.place, "has one of x and y", "give both, or none");
    const auto measured = geographic ? point(row.degrees("latitude", 90), row.degrees("longitude", 180))
                                     : point(row.length("east"), row.length("north"));
    if (!measured) return tl::unexpected(measured.error());
    if (geographic)
        marker.measured = Geographic{measured->x, measured->y};
    else
        marker.measured = *measured;
    if (row.has("x")) {
        const auto at = point(row.length("x"), row.length("y"));
        if (!at) return tl::unexpected(at.error());
        marker.canvas = *at;
    }
    if (row.has("radius")) {
        const auto radius = row.length("radius");
        if (!radius) return tl::unexpected(radius.error());
        if (*radius < 0) return fail(row.place + ", radius", "is below 0", "use 0 for a flag");
        marker.radius = *radius;
    }
    if (!marker.canvas && !(marker.radius > 0))
        return fail(row.place, "has neither x and y nor a radius: it would say nothing",
                    "give its place on the canvas, or the radius of a pole");
    return marker;
}

}  // namespace

Outcome<std::vector<Marker>> read_markers(const std::string& csv, const std::string& place) {
    std::vector<Marker> markers;
    std::vector<std::string> names;
    std::istringstream lines(csv);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const auto cells = cells_of(line);
        if (line.starts_with('#') || (cells.size() == 1 && cells.front().empty())) continue;
        if (names.empty()) {
            names = cells;
            continue;
        }
        Row row{{}, fmt::format("{} line {}", place, number)};
        if (cells.size() > names.size())
            return fail(row.place, "has more values than there are columns", columns);
        for (std::size_t k = 0; k < cells.size(); ++k) row.cells[names[k]] = cells[k];
        auto marker = marker_of(row);
        if (!marker) return tl::unexpected(marker.error());
        if (marker->name.empty()) marker->name = std::to_string(markers.size() + 1);
        markers.push_back(std::move(*marker));
    }
    if (markers.empty()) return fail(place, "holds no markers", columns);
    return markers;
}

}  // namespace strandline
