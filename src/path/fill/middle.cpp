// Middle lines of thin areas, and rounded corners.
#include <algorithm>
#include <span>

#include "path/fill/rings.hpp"

namespace strandline::fill {
namespace {
constexpr int tips = 48;     // places tried as the tip
constexpr int samples = 64;  // pairs along a middle line
}  // namespace

Polyline middle_line(const Polygon& outline, double widest) {
    if (outline.size() < 3) return {};
    const double round = perimeter(outline);
    Polyline loop = outline;
    loop.push_back(outline.front());
    // Equal steps around, so that pairs are plain indices; corners are added as candidates by their nearest
    // sample.
    constexpr int n = 2 * samples * 2;
    std::vector<Point> even;
    {
        double s = 0, next = 0;
        for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
            const double d = distance(loop[i], loop[i + 1]);
            while (next <= s + d && static_cast<int>(even.size()) < n) {
                even.push_back(d > 0 ? between(loop[i], loop[i + 1], (next - s) / d) : loop[i]);
                next += round / n;
            }
            s += d;
        }
        while (static_cast<int>(even.size()) < n) even.push_back(loop.back());
    }
    const auto cost = [&](int tip) {
        double sum = 0;
        for (int k = 1; k < n / 2; ++k) sum += distance(even[(tip + k) % n], even[(tip + n - k) % n]);
        return sum;
    };
    int best = 0;
    for (int tip = 0, step = std::max(1, n / 2 / tips); tip < n / 2; tip += step)
        if (cost(tip) < cost(best)) best = tip;
    for (int tip : {best + n - 2, best + n - 1, best + 1, best + 2})
        if (cost(tip % n) < cost(best)) best = tip % n;
    Polyline middle{even[best]};
    for (int k = 2; k < n / 2; k += 2) {
        const Point a = even[(best + k) % n], b = even[(best + n - k) % n];
        if (distance(a, b) > widest) return {};
        middle.push_back(between(a, b, 0.5));
    }
    middle.push_back(even[(best + n / 2) % n]);
    return middle;
}

Polyline thinned(const Polyline& line, double tolerance) {
    Polyline kept;
    for (const std::size_t i : strandline::thinned(std::span(line), tolerance)) kept.push_back(line[i]);
    return kept;
}

Polyline rounded(const Polyline& line, double radius) {
    constexpr double least_turn = 0.1, arc_step = 0.15;  // rad
    if (radius <= 0 || line.size() < 3) return line;
    Polyline smooth{line.front()};
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Point a = line[i - 1], b = line[i], c = line[i + 1];
        const Point in = normalized(b - a), out = normalized(c - b);
        const double turn = std::atan2(cross(in, out), dot(in, out));
        if (std::abs(turn) < least_turn || std::abs(turn) > pi - least_turn) {
            smooth.push_back(b);
            continue;
        }
        const double half = std::tan(std::abs(turn) / 2);
        const double cut = std::min({radius * half, distance(a, b) / 2, distance(b, c) / 2});
        const double r = cut / half;
        const Point from = b - cut * in;
        const Point centre = from + (turn > 0 ? r : -r) * left_normal(in);
        const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / arc_step)));
        const double start = heading(from - centre);
        for (int k = 0; k <= steps; ++k) smooth.push_back(centre + r * unit(start + turn * k / steps));
    }
    smooth.push_back(line.back());
    return without_duplicates(smooth, 1e-12);
}

}  // namespace strandline::fill
