#include "result/fidelity/lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "math/nearest/nearest.hpp"

namespace strandline::fidelity {
namespace {

using surface::Surface;

/// Chords that stand for a line leave it by this share of a pin at most.
constexpr double chord_error = 0.01;
/// Pins between two places at which a line's width is measured.
constexpr double probe_step = 2;

/// Means over metres.
struct Lateral {
    double metres = 0, sum = 0, squares = 0, most = 0;
    void add(double error, double step) {
        metres += step;
        sum += error * step;
        squares += error * error * step;
        most = std::max(most, error);
    }
};

struct Width {
    int places = 0, undrawn = 0;
    double bias = 0, error = 0;
};

/// Looks across a line in the sand, from its middle to both sides, as long as the sand is raked. Where other
/// things are wanted beside it, it says nothing.
void probe(const Surface& sand, Point at, Point across, double wanted, double pin, Width& width) {
    const double step = sand.cell_size() / 4;
    const int most = static_cast<int>(wanted / step);
    const auto is_raked = [&](Point p) { return (sand.bits(p) & surface::raked) != 0; };
    if (!is_raked(at)) {
        ++width.undrawn;
        return;
    }
    constexpr unsigned other = surface::wanted_line | surface::wanted_fill;
    for (const double side : {1.0, -1.0})
        if ((sand.bits(at + side * (wanted + pin) / 2 * across) & other) != 0) return;
    int met = 1;
    for (const Point side : {across, -across}) {
        int reach = 1;
        while (reach <= most && is_raked(at + reach * step * side)) ++reach;
        if (reach > most) return;  // it runs into something else
        met += reach - 1;
    }
    const double off = met * step - wanted;
    ++width.places;
    width.bias += off;
    width.error += std::abs(off);
}

void probe_line(const Surface& sand, const Polyline& chords, bool closed, double wanted, double pin,
                Width& width) {
    Polyline line = chords;
    if (closed) line.push_back(chords.front());
    const double step = probe_step * pin;
    double next = step / 2, walked = 0;
    for (std::size_t k = 1; k < line.size(); ++k) {
        const double piece = distance(line[k - 1], line[k]);
        for (; piece > 0 && walked + piece >= next; next += step)
            probe(sand, between(line[k - 1], line[k], (next - walked) / piece),
                  left_normal(normalized(line[k] - line[k - 1])), wanted, pin, width);
        walked += piece;
    }
}

}  // namespace

void measure_lines(const Drawing& drawing, const surface::Drive& drive, const Surface& sand, Report& report) {
    const Robot& robot = drive.robot;
    const double tolerance = chord_error * robot.pin_pitch, step = probe_step * robot.pin_pitch;
    std::map<int, SegmentTree> lines;
    Width width;
    for (std::size_t e = 0; e < drawing.elements.size(); ++e) {
        const auto* line = std::get_if<LineElement>(&drawing.elements[e].what);
        if (line == nullptr) continue;
        const Polyline chords = flattened(line->path, tolerance);
        if (chords.size() < 2) continue;
        lines.emplace(static_cast<int>(e), SegmentTree(segments_of(chords, line->path.closed)));
        report.line_length += length(line->path);
        probe_line(sand, chords, line->path.closed, groove_width(robot, line->pins), robot.pin_pitch, width);
    }
    Lateral lateral;
    for (std::size_t i = 0; i + 1 < drive.samples.size() && i < drive.elements.size(); ++i) {
        const auto line = drive.samples[i].mask == 0 ? lines.end() : lines.find(drive.elements[i]);
        if (line == lines.end()) continue;
        const Sample &a = drive.samples[i], &b = drive.samples[i + 1];
        lateral.add(line->second.distance(drawn_at(robot, a, a.mask)),
                    distance(drawn_at(robot, a, a.mask), drawn_at(robot, b, a.mask)));
    }
    if (lateral.metres > 0) {
        report.lateral_mean = lateral.sum / lateral.metres;
        report.lateral_rms = std::sqrt(lateral.squares / lateral.metres);
        report.lateral_max = lateral.most;
    }
    if (width.places > 0) {
        report.width_bias = width.bias / width.places;
        report.width_error = width.error / width.places;
    }
    report.undrawn = width.undrawn * step;
}

std::vector<int> elements_drawn(const Drawing& drawing, const Robot& robot,
                                const std::vector<Sample>& samples) {
    struct Candidate {
        Box box;
        std::optional<SegmentTree> line;
        std::optional<BandedRegion> area;
    };
    const double reach = robot.rake_width();
    std::vector<Candidate> candidates;
    for (const Element& element : drawing.elements) {
        Candidate candidate;
        if (const auto* line = std::get_if<LineElement>(&element.what)) {
            const Polyline chords = flattened(line->path, chord_error * robot.pin_pitch);
            candidate.box = grown(bounds(chords), reach);
            candidate.line.emplace(segments_of(chords, line->path.closed));
        } else {
            const Region& region = std::get<RegionElement>(element.what).region;
            candidate.box = bounds(region);
            candidate.area.emplace(region);
        }
        candidates.push_back(std::move(candidate));
    }
    std::vector<int> drawn(samples.size(), -1);
    for (std::size_t first = 0; first < samples.size(); ++first) {
        if (samples[first].mask == 0) continue;
        std::size_t end = first;
        while (end < samples.size() && samples[end].mask != 0) ++end;
        // Over the whole go: its mean distance from each line, and the share of it that each area holds.
        int best = -1;
        double least = reach / 2;
        const double count = static_cast<double>(end - first);
        for (std::size_t e = 0; e < candidates.size(); ++e) {
            const Candidate& candidate = candidates[e];
            double off = 0;
            for (std::size_t i = first; i < end && off <= least * count; ++i) {
                const Point p = drawn_at(robot, samples[i], samples[i].mask);
                if (!contains(candidate.box, p))
                    off += reach;
                else if (candidate.line)
                    off += candidate.line->distance(p);
                else
                    off += candidate.area->contains(p) ? 0 : reach;
            }
            // A line over an area: lines are followed to a centimetre, areas held by all that is in them.
            const double mean = off / count + (candidate.line ? 0 : reach / 8);
            if (mean < least) {
                least = mean;
                best = static_cast<int>(e);
            }
        }
        std::fill(drawn.begin() + static_cast<std::ptrdiff_t>(first),
                  drawn.begin() + static_cast<std::ptrdiff_t>(end), best);
        first = end - 1;
    }
    return drawn;
}

}  // namespace strandline::fidelity
