// A narrow area raked across.
#include "path/fill/comb.hpp"

#include <algorithm>

namespace strandline::fill {
namespace {

constexpr double tangent_over = 0.5;   // of the width, to both sides: the direction of the middle line
constexpr double last_share = 0.1;     // of the width: less sand at a comb's end gets no further tooth
constexpr double smallest_step = 0.7;  // of the width: where the area widens at once the next ends lie apart
constexpr double widest_excess = 0.8;  // of the width: less than the ring outside is wide
constexpr int end_halvings = 5;
constexpr double end_step =
    0.1;  // of the width: where a comb begins beside another is looked for so, then halved
constexpr double least_evened = 0.995, evening_slack = 0.003;
constexpr int most_tries = 8;
constexpr double shortest_tooth = 0.08;  // of the width
// How far a tooth may reach, of the radius and of the width: not down a side branch.
constexpr double reach_of_radius = 1.35, reach_of_width = 0.35;
constexpr double least_misfit = 0.06;  // of the width, along the outline: combs waste as much
constexpr int several_levels = 3;
constexpr double long_edges = 2;  // widths

/// The path by arc length; open ones go straight on at both ends.
class Spine {
  public:
    explicit Spine(const AxisPath& path) : line_(path.line), radius_(path.radius), closed_(path.closed) {
        if (closed_) {
            line_.push_back(line_.front());
            radius_.push_back(radius_.front());
        }
        arcs_.push_back(0);
        for (std::size_t i = 1; i < line_.size(); ++i)
            arcs_.push_back(arcs_.back() + distance(line_[i - 1], line_[i]));
    }
    double length() const { return arcs_.back(); }
    bool closed() const { return closed_; }
    Point at(double s) const {
        const auto [i, t] = place(s);
        return between(line_[i], line_[i + 1], t);
    }
    double radius(double s) const {
        const auto [i, t] = place(s);
        return radius_[i] + std::clamp(t, 0.0, 1.0) * (radius_[i + 1] - radius_[i]);
    }

  private:
    std::pair<std::size_t, double> place(double s) const {
        if (closed_) {
            s = std::fmod(s, length());
            if (s < 0) s += length();
        }
        const auto after = std::ranges::upper_bound(arcs_, s);
        std::size_t i = after == arcs_.begin() ? 0 : static_cast<std::size_t>(after - arcs_.begin()) - 1;
        i = std::min(i, line_.size() - 2);
        const double d = arcs_[i + 1] - arcs_[i];
        return {i, d > 0 ? (s - arcs_[i]) / d : 0};
    }
    Polyline line_;
    std::vector<double> radius_, arcs_;
    bool closed_;
};

std::optional<Polyline> tooth_at(const Regions& area, const Spine& spine, double s, double w) {
    const Point t = normalized(spine.at(s + tangent_over * w) - spine.at(s - tangent_over * w));
    const Point c = spine.at(s), n = left_normal(t);
    const double most = reach_of_radius * spine.radius(s) + reach_of_width * w;
    // As far as any of the sand before the bar does, but no part of it more than a width beyond its sand:
    // there the ring outside of the area is.
    double up = 0, down = 0, least_up = most, least_down = most;
    for (double o : {-0.45, -0.2, 0.0, 0.2, 0.45}) {
        const Reach reach = reach_from(area, c + o * w * t, n).value_or(Reach{});
        up = std::max(up, std::min(most, reach.forward));
        down = std::max(down, std::min(most, reach.backward));
        least_up = std::min(least_up, reach.forward);
        least_down = std::min(least_down, reach.backward);
    }
    up = std::min(up, least_up + widest_excess * w);
    down = std::min(down, least_down + widest_excess * w);
    if (up + down < shortest_tooth * w) return std::nullopt;
    return Polyline{c - down * n, c + up * n};
}

/// As far on as the next tooth's ends are within `most` of this one's.
double step_from(const Regions& area, const Spine& spine, double s, const Polyline& tooth, double w,
                 double most) {
    double step = most;
    for (int i = 0; i < most_tries; ++i) {
        const auto next = tooth_at(area, spine, s + step, w);
        if (!next) return most;
        const double apart = std::max(distance(tooth[0], (*next)[0]), distance(tooth[1], (*next)[1]));
        if (apart <= most) return step;
        if (step <= smallest_step * w) return most;  // the area widens at once: no step is small enough
        step = std::max(smallest_step * w, step * std::min(most / apart, 0.995));
    }
    return step;
}

/// The part of an open spine that has a comb.
struct Stretch {
    double from, to;
};

/// From raked sand to raked sand: the ends of a spine lie a disc's radius off a path that it branches from.
Stretch unraked_stretch(const Regions& unraked, const Spine& spine, double w) {
    const double step = end_step * w;
    const auto inside = [&](double s) { return contains(unraked, spine.at(s)); };
    Stretch all{0, spine.length()};
    while (all.from < all.to && !inside(all.from)) all.from += step;
    while (all.from < all.to && !inside(all.to)) all.to -= step;
    const double most = w + 2 * std::max(spine.radius(0), spine.radius(spine.length()));
    while (all.from <= 0 && all.from > -most && inside(all.from - step)) all.from -= step;
    while (all.to >= spine.length() && all.to < spine.length() + most && inside(all.to + step))
        all.to += step;
    const auto refined = [&](double in, double out) {
        for (int i = 0; i < end_halvings; ++i) (inside((in + out) / 2) ? in : out) = (in + out) / 2;
        return in;
    };
    if (all.from < all.to) {
        all.from = refined(all.from, all.from - step);
        all.to = refined(all.to, all.to + step);
    }
    return all;
}

struct Teeth {
    std::vector<Polyline> lines;
    double room = 1;  // what of the steps' sum is needed
};

Teeth teeth_along(const Regions& area, const Spine& spine, const Stretch& stretch, double w, double most) {
    Teeth teeth;
    const double begin = spine.closed() ? 0 : std::min(stretch.from + w / 2, (stretch.from + stretch.to) / 2);
    const double end = spine.closed() ? spine.length() : stretch.to - w / 2;
    for (double s = begin;;) {
        const auto tooth = tooth_at(area, spine, s, w);
        if (tooth) teeth.lines.push_back(*tooth);
        const double left = end - s;
        if (!spine.closed() && left < last_share * w) break;
        const double next = s + (tooth ? step_from(area, spine, s, *tooth, w, most) : w);
        if (next > end) teeth.room = (end - begin) / (next - begin);
        if (spine.closed() && left < w * (1 + last_share)) break;
        s = spine.closed() ? next : std::min(next, end);
    }
    return teeth;
}

/// Teeth with even steps: what one too many would rake twice is shared by all.
std::vector<Polyline> even_teeth(const Regions& area, const Spine& spine, const Stretch& stretch, double w) {
    Teeth teeth = teeth_along(area, spine, stretch, w, w);
    if (teeth.room > least_evened) return std::move(teeth.lines);
    Teeth even =
        teeth_along(area, spine, stretch, w, std::max(smallest_step, teeth.room + evening_slack) * w);
    return std::move(even.lines.size() <= teeth.lines.size() ? even.lines : teeth.lines);
}

}  // namespace

bool combs_may_pay(const Region& sand, int levels, double waste, double width) {
    double round = perimeter(sand.outer);
    std::size_t edges = sand.outer.size();
    for (const Polygon& hole : sand.holes) round += perimeter(hole), edges += hole.size();
    return waste >= least_misfit * width * round &&
           (levels < several_levels || round >= long_edges * width * static_cast<double>(edges));
}

std::vector<Comb> combs_of(const Region& area, const std::vector<AxisPath>& paths, const Options& options) {
    const double w = options.width;
    std::vector<Comb> combs;
    Regions unraked{area};
    for (const AxisPath& path : paths) {
        const Spine spine(path);
        const Stretch whole{0, spine.length()};
        const Stretch stretch = spine.closed() ? whole : unraked_stretch(unraked, spine, w);
        if (stretch.to - stretch.from < last_share * w) continue;
        Comb comb{path.line, even_teeth(unraked, spine, stretch, w)};
        if (comb.teeth.empty()) continue;
        if (&path != &paths.back()) unraked = subtracted(unraked, swept(comb.teeth, false, w / 2, Cap::flat));
        combs.push_back(std::move(comb));
    }
    return combs;
}

}  // namespace strandline::fill
