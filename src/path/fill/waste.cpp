#include "path/fill/waste.hpp"

#include <algorithm>

namespace strandline::fill {
namespace {

constexpr int most_directions = 12;
constexpr int most_phases = 4;  // edges that rows are tried flush with
// Of the spacing, by length along the lines of a slanted edge: up to 45 degrees, and at most.
constexpr double steep_waste = 0.14, most_end_waste = 0.3, waste_by_slant = 0.07;
constexpr double flat = 0.35;         // of the spacing: an edge that rises by less lies along the lines
constexpr double flush = 0.02;        // of the spacing: an edge that near to the raster wastes nothing
constexpr double least_share = 0.06;  // of a row: less is left bare
constexpr double missing_cost = 3;    // m^2 overlapped that one left bare counts for
constexpr double half_cost = 0.3;     // of a row, more, where the border would be driven over raked sand
// Of width^2. A vehicle that cannot turn on the spot leaves a drop of sand bare between two lines; where it
// goes over a cut, it is lifted and drives a loop of its radius, whose way is weighed as sand raked twice.
constexpr double free_line_cost = 0.03, driven_turn_cost = 0.7, free_cut_cost = 0.3;

struct Edge {
    Point a, b;
};

double waste_in(const std::vector<Edge>& edges, double direction, const Options& options) {
    const double s = options.spacing;
    const Point u = unit(direction), n = left_normal(u);
    struct Flat {
        double length, y;
        bool bottom;
    };
    std::vector<Flat> flats;
    double waste = 0, height = 0;
    for (const Edge& edge : edges) {
        const double along = dot(edge.b - edge.a, u), across = std::abs(dot(edge.b - edge.a, n));
        height += across;
        if (across < flat * s)
            flats.push_back({std::abs(along), dot(edge.a + edge.b, n) / 2, along > 0});
        else
            waste += s * std::abs(along) *
                     std::clamp(steep_waste + waste_by_slant * (std::abs(along) / across - 1), steep_waste,
                                most_end_waste);
    }
    waste += line_cost(options) * height / (2 * s);
    std::ranges::sort(flats, [](const Flat& a, const Flat& b) {
        return std::tuple(-a.length, a.y) < std::tuple(-b.length, b.y);
    });
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < std::max<std::size_t>(1, std::min<std::size_t>(most_phases, flats.size()));
         ++k) {
        double sum = 0;
        for (const Flat& edge : flats) {
            const double rows = (edge.bottom ? flats[k].y - edge.y : edge.y - flats[k].y) / s;
            const double share = rows - std::floor(rows);
            if (share < flush || share > 1 - flush) continue;
            const double lost =
                share < least_share ? missing_cost * share : 1 - share + (share < 0.5 ? half_cost : 0);
            sum += lost * s * edge.length;
        }
        least = std::min(least, sum);
    }
    return waste + least;
}

}  // namespace

double line_cost(const Options& options) {
    return (options.turn_radius > 0 ? driven_turn_cost : free_line_cost) * options.width * options.width;
}

double cut_cost(const Options& options) {
    return std::max(free_cut_cost * options.width * options.width,
                    2 * pi * options.turn_radius * options.width);
}

Waste least_waste(const Region& area, std::optional<double> direction, const Options& options) {
    return least_wastes(area, direction, 1, options).front();
}

std::vector<Waste> least_wastes(const Region& area, std::optional<double> direction, std::size_t most,
                                const Options& options) {
    std::vector<Edge> edges;
    const auto ring = [&](const Polygon& polygon) {
        for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
            edges.push_back({polygon[j], polygon[i]});
    };
    ring(area.outer);
    for (const Polygon& hole : area.holes) ring(hole);
    if (direction) return {{*direction, waste_in(edges, *direction, options)}};

    std::vector<std::pair<double, double>> by_length;
    for (const Edge& edge : edges) {
        double along = heading(edge.b - edge.a);
        if (along < 0) along += pi;
        if (along >= pi - 1e-9) along = 0;
        by_length.emplace_back(-distance(edge.a, edge.b), along);
    }
    std::ranges::sort(by_length);
    std::vector<double> tried;
    std::vector<Waste> best;
    const auto attempt = [&](double along) {
        along = std::fmod(along, pi);
        if (std::ranges::any_of(tried, [&](double other) { return std::abs(other - along) < 0.01; })) return;
        tried.push_back(along);
        const Waste waste{along, waste_in(edges, along, options)};
        best.insert(std::ranges::upper_bound(best, waste.area - 1e-9, {}, &Waste::area), waste);
        if (best.size() > most) best.pop_back();
    };
    for (const auto& [minus_length, along] : by_length) {
        if (static_cast<int>(tried.size()) >= most_directions) break;
        attempt(along);
        attempt(along + pi / 2);
    }
    return best;
}

}  // namespace strandline::fill
