#include "input/svg/dashes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace strandline::svg {

namespace {

struct Interval {
    double from, to;
};

/// Where along a path of that length there is ink.
std::vector<Interval> inked(double whole, const DashPattern& pattern) {
    auto lengths = pattern.lengths;
    if (lengths.size() % 2 == 1)
        lengths.insert(lengths.end(), pattern.lengths.begin(), pattern.lengths.end());
    double sum = 0;
    for (const double length : lengths) sum += length;
    double phase = std::fmod(pattern.offset, sum);
    if (phase < 0) phase += sum;
    std::vector<Interval> found;
    for (double round = 0; round * sum - phase < whole; ++round) {
        double at = round * sum - phase;
        for (std::size_t i = 0; i + 1 < lengths.size(); i += 2) {
            const double from = at, to = at + lengths[i];
            at = to + lengths[i + 1];
            if (to < 0 || from > whole || (to == from && !pattern.dots) || (to == 0 && from < 0)) continue;
            const Interval cut{std::max(from, 0.0), std::min(to, whole)};
            if (!found.empty() && cut.from <= found.back().to)
                found.back().to = cut.to;  // a gap of no length
            else
                found.push_back(cut);
        }
    }
    return found;
}

}  // namespace

std::optional<std::vector<Path>> dashed(const Path& path, const DashPattern& pattern, std::size_t most) {
    const double whole = length(path);
    double sum = 0;
    for (const double length : pattern.lengths) sum += length;
    const double wanted = (whole / sum + 1) * static_cast<double>(pattern.lengths.size());
    if (!(wanted <= static_cast<double>(most))) return std::nullopt;
    const auto intervals = inked(whole, pattern);
    if (intervals.size() == 1 && intervals[0].from <= 0 && intervals[0].to >= whole) return std::vector{path};

    std::vector<double> cuts;
    for (const auto& [from, to] : intervals) {
        cuts.push_back(from);
        cuts.push_back(to);
    }
    auto pieces = split(path, places_at(path, cuts));  // gap, dash, gap, dash ... gap
    std::vector<Path> dashes;
    for (std::size_t i = 1; i < pieces.size(); i += 2) {
        if (pieces[i].segments.empty()) {
            if (!pattern.dots) continue;
            pieces[i].segments.emplace_back(LineSegment{pieces[i].start});
        }
        dashes.push_back(std::move(pieces[i]));
    }
    if (path.closed && dashes.size() > 1 && intervals.front().from <= 0 && intervals.back().to >= whole) {
        auto& first = dashes.front().segments;
        std::ranges::move(first, std::back_inserter(dashes.back().segments));
        dashes.erase(dashes.begin());
    }
    return dashes;
}

}  // namespace strandline::svg
