#include "path/rake/pin_steps.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::rake {
namespace {

constexpr double hard_turn = 0.17;   // radians: what turns less is a bend drawn by chords
constexpr double corner_side = 0.2;  // cells of a corner's step on either side, at most a quarter of a chord

}  // namespace

std::vector<std::vector<PinStep>> pin_steps(const std::vector<Track>& tracks,
                                            const std::vector<Polyline>& ways, const Raster& raster,
                                            double longest) {
    std::vector<std::vector<PinStep>> all;
    double arc = 0;
    std::optional<Point> end;  // of the last stroke, metres
    for (std::size_t stroke = 0; stroke < tracks.size(); ++stroke) {
        const Track& track = tracks[stroke];
        std::vector<PinStep>& steps = all.emplace_back();
        if (track.line.size() < 2) continue;
        if (end) {
            Polyline way{*end};
            if (stroke < ways.size()) way.insert(way.end(), ways[stroke].begin(), ways[stroke].end());
            way.push_back(track.line.front());
            arc += length(way) / raster.cell;
        }
        end = track.line.back();
        const std::size_t chords = track.line.size() - 1;
        const auto chord = [&](std::size_t i) {
            return raster.in_cells(track.line[i + 1]) - raster.in_cells(track.line[i]);
        };
        const auto side = [&](std::size_t i) {  // of the step at the corner where chord i begins
            if (i == 0 || i >= chords) return 0.0;
            const Point before = chord(i - 1), after = chord(i);
            if (std::abs(std::atan2(cross(before, after), dot(before, after))) < hard_turn) return 0.0;
            return std::min({corner_side, length(before) / 4, length(after) / 4});
        };
        for (std::size_t i = 0; i < chords; ++i) {
            const Point from = raster.in_cells(track.line[i]), ahead = normalized(chord(i));
            const double whole = length(chord(i));
            const auto metres_a_cell = [&](std::size_t j) {
                return (track.arcs[j + 1] - track.arcs[j]) / length(chord(j));
            };
            const double metres = metres_a_cell(i);
            const double begin = side(i), last = whole - side(i + 1);
            if (begin > 0) {
                const Point before = normalized(chord(i - 1));
                steps.push_back({track.arcs[i] - begin * metres_a_cell(i - 1), track.arcs[i] + begin * metres,
                                 arc - begin, from, ahead, begin, before, true, false});
            }
            const double count = std::max(1.0, std::ceil((last - begin) / longest));
            const double step = (last - begin) / count;
            for (double k = 0; k < count; ++k) {
                const double at = begin + k * step;
                steps.push_back({track.arcs[i] + at * metres,
                                 track.arcs[i] + (at + step) * metres,
                                 arc + at,
                                 from + at * ahead,
                                 ahead,
                                 step,
                                 {},
                                 false,
                                 k > 0});
            }
            arc += whole;
        }
    }
    return all;
}

}  // namespace strandline::rake
