// Passes half a pitch beside a part's middle, where pins fit its borders better there.
#include <algorithm>
#include <cmath>

#include "path/fill/narrow.hpp"

namespace strandline::fill {
namespace {

/// What pins about the middle of an arm leave bare or rake outside, m^2 in all: at each place the number that
/// fits best of those that lie evenly about it, `fewest`, two more, and so on.
double misfit(const Axis& axis, const std::vector<int>& nodes, int fewest, const Options& options) {
    const double pitch = options.width / options.pins, most = options.pins - (options.pins - fewest) % 2;
    double sum = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const MedialAxis::Node &a = axis.nodes[nodes[i - 1]], &b = axis.nodes[nodes[i]];
        const double wide = a.radius + b.radius;
        const double pins = std::clamp(fewest + 2 * std::round((wide / pitch - fewest) / 2),
                                       static_cast<double>(fewest), most);
        sum += distance(a.at, b.at) * std::abs(wide - pins * pitch);
    }
    return sum;
}

}  // namespace

double aside_of(const Axis& axis, const std::vector<int>& nodes, const Options& options) {
    if (!options.masked || options.pins < 2) return 0;
    const int centred = options.pins % 2 == 0 ? 2 : 1, beside = 3 - centred;
    return misfit(axis, nodes, beside, options) < misfit(axis, nodes, centred, options)
               ? options.width / options.pins / 2
               : 0;
}

Polyline moved_aside(const Polyline& line, double left) {
    constexpr double sharpest = 0.5;  // cosine of half a turn: mitres of sharper ones end there
    const std::size_t n = line.size();
    if (left == 0 || n < 2) return line;
    const bool closed = n > 2 && line.front() == line.back();
    const Point before = closed ? line[n - 2] : 2 * line[0] - line[1],
                after = closed ? line[1] : 2 * line[n - 1] - line[n - 2];
    Polyline moved;
    for (std::size_t i = 0; i < n; ++i) {
        const Point in = left_normal(normalized(line[i] - (i > 0 ? line[i - 1] : before))),
                    out = left_normal(normalized((i + 1 < n ? line[i + 1] : after) - line[i])),
                    across = normalized(in + out);
        moved.push_back(line[i] + left / std::max(sharpest, dot(across, in)) * across);
    }
    return moved;
}

}  // namespace strandline::fill
