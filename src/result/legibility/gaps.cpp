// Gaps: along every line and outline, in short steps, the nearest place of each other element that lies
// beside it, as long as nothing is drawn between the two.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "math/nearest/nearest.hpp"
#include "result/legibility/details.hpp"

namespace strandline::legibility {
namespace {

/// Metres between the places of a line that are looked at, in pins.
constexpr double place_step = 0.25;
/// Where two lines part or meet at more than 6 degrees their gap runs out in a point, as areas do in a tip.
constexpr double gap_slope = 2 * tip_slope;
/// Half a gap's width, as a share of it, about its middle has to be empty: what is nearer lies between the
/// two, or they lie at more than 37 degrees to each other.
constexpr double empty_share = 0.8;
/// Pins along which a gap may be interrupted, as at a corner, and is still one.
constexpr double most_missed = 2;
/// Segments that are held against a place in all: half a second.
constexpr std::size_t most_looked_at = 10'000'000;

/// A line, or one outline of an area.
struct Border {
    int element;
    Polyline chain;  ///< closed ones end where they begin
    bool closed;
};

std::vector<Border> borders_of(const Drawing& drawing, double tolerance) {
    std::vector<Border> borders;
    const auto add = [&](std::size_t element, Polyline chain, bool closed) {
        if (closed && !chain.empty()) chain.push_back(chain.front());
        if (chain.size() > 1) borders.push_back({static_cast<int>(element), std::move(chain), closed});
    };
    for (std::size_t e = 0; e < drawing.elements.size(); ++e) {
        if (const auto* line = std::get_if<LineElement>(&drawing.elements[e].what)) {
            add(e, flattened(line->path, tolerance), line->path.closed);
            continue;
        }
        const Region& region = std::get<RegionElement>(drawing.elements[e].what).region;
        add(e, region.outer, true);
        for (const Polygon& hole : region.holes) add(e, hole, true);
    }
    return borders;
}

/// The nearest place of another element, seen from a place on a border.
struct Seen {
    int other;
    Point from, to;
    double distance;
};

class Finder {
  public:
    Finder(const Drawing& drawing, const Robot& robot)
        : drawing_(drawing),
          pin_(robot.pin_pitch),
          half_(drawing.elements.size(), 0),
          areas_(drawing.elements.size()),
          borders_(borders_of(drawing, pin_ / 20)) {
        for (std::size_t e = 0; e < half_.size(); ++e)
            if (const auto* line = std::get_if<LineElement>(&drawing.elements[e].what))
                half_[e] = groove_width(robot, line->pins) / 2;
        widest_ = half_.empty() ? 0 : *std::ranges::max_element(half_);
        SegmentTree::Segments segments;
        for (const Border& border : borders_) {
            const auto own = segments_of(border.chain, false);
            segments.insert(segments.end(), own.begin(), own.end());
            owner_.resize(segments.size(), border.element);
        }
        squares_.emplace(std::move(segments), 2 * widest_ + pin_);
    }

    bool find(std::vector<Detail>& details) {
        for (const Border& border : borders_) {
            along(border, details);
            if (looked_at_ > most_looked_at) return false;
        }
        return true;
    }

  private:
    double needed(int a, int b) const { return half(a) + half(b) + pin_; }
    double half(int element) const { return half_[static_cast<std::size_t>(element)]; }

    /// Side by side with one other element: what was seen of it place after place.
    struct Run {
        std::vector<Seen> seen;
        std::size_t last = 0;  ///< place
    };

    void along(const Border& border, std::vector<Detail>& details) {
        const double whole = length(border.chain);
        const auto steps = static_cast<std::size_t>(std::ceil(whole / (place_step * pin_)));
        if (steps == 0) return;
        std::vector<std::vector<Seen>> places(steps + (border.closed ? 0 : 1));
        double walked = 0;
        std::size_t next = 0;
        for (std::size_t k = 1; k < border.chain.size(); ++k) {
            const Point a = border.chain[k - 1], b = border.chain[k];
            const double piece = distance(a, b);
            const double step = whole / static_cast<double>(steps);
            for (; next < places.size() && static_cast<double>(next) * step <= walked + piece; ++next) {
                const double share = piece > 0 ? (static_cast<double>(next) * step - walked) / piece : 0;
                places[next] = seen_from(between(a, b, std::clamp(share, 0.0, 1.0)), border.element);
                if (looked_at_ > most_looked_at) return;
            }
            walked += piece;
        }
        // A closed one is begun where nothing is near, if there is such a place.
        if (border.closed)
            std::ranges::rotate(places,
                                std::ranges::find_if(places, [](const auto& seen) { return seen.empty(); }));
        std::map<int, Run> open;
        for (std::size_t place = 0; place < places.size(); ++place) {
            for (const Seen& seen : places[place]) {
                Run& run = open[seen.other];
                run.seen.push_back(seen);
                run.last = place;
            }
            std::erase_if(open, [&](const auto& run) {
                if (static_cast<double>(place - run.second.last) * place_step < most_missed) return false;
                close(border.element, run.second.seen, details);
                return true;
            });
        }
        for (const auto& [other, run] : open) close(border.element, run.seen, details);
    }

    /// Of each later element that has a gap with this one here, which would not be seen.
    std::vector<Seen> seen_from(Point from, int element) {
        std::map<int, Seen> nearest;
        for (const SegmentSquares::Near& near : looked(from, half(element) + widest_ + pin_)) {
            const int other = owner_[near.number];
            if (other <= element || near.distance >= needed(element, other)) continue;
            const auto [at, is_new] = nearest.try_emplace(other, Seen{other, from, near.at, near.distance});
            if (!is_new && near.distance < at->second.distance)
                at->second = {other, from, near.at, near.distance};
        }
        std::vector<Seen> list;
        for (const auto& [other, seen] : nearest)
            if (is_clean(seen, element)) list.push_back(seen);
        return list;
    }

    std::vector<SegmentSquares::Near> looked(Point at, double reach) {
        auto near = squares_->near(at, reach);
        looked_at_ += near.size() + 1;
        return near;
    }

    /// Nothing lies between, and it is not sand of an area.
    bool is_clean(const Seen& seen, int element) {
        const Point middle = between(seen.from, seen.to, 0.5);
        if (!looked(middle, empty_share * seen.distance / 2).empty()) return false;
        return !is_filled(element, middle) && !is_filled(seen.other, middle);
    }
    /// By the element or one that encloses it.
    bool is_filled(int element, Point p) {
        for (int e = element; e >= 0; e = drawing_.elements[static_cast<std::size_t>(e)].inside) {
            const auto at = static_cast<std::size_t>(e);
            const auto* area = std::get_if<RegionElement>(&drawing_.elements[at].what);
            if (area == nullptr) continue;
            if (!areas_[at]) areas_[at].emplace(area->region);
            if (areas_[at]->contains(p)) return true;
        }
        return false;
    }

    /// A gap that runs out, or touches, counts for its even stretches.
    void close(int element, const std::vector<Seen>& run, std::vector<Detail>& details) {
        const double touching = least_share * pin_;
        const bool touches =
            std::ranges::any_of(run, [&](const Seen& seen) { return seen.distance <= place_step * pin_; });
        double metres = 0;
        const Seen* best = nullptr;
        const auto done = [&] {
            if (best != nullptr && metres >= pin_)
                details.push_back({Detail::Kind::gap, element, between(best->from, best->to, 0.5),
                                   best->distance, needed(element, best->other), best->other});
            metres = 0;
            best = nullptr;
        };
        for (std::size_t k = 0; k < run.size(); ++k) {
            const double way = k == 0 ? 0 : distance(run[k - 1].from, run[k].from);
            const bool even = k == 0 || std::abs(run[k].distance - run[k - 1].distance) <= gap_slope * way;
            if (run[k].distance <= touching || (touches && !even)) {
                done();
                continue;
            }
            metres += way;
            if (best == nullptr || run[k].distance < best->distance) best = &run[k];
        }
        done();
    }

    const Drawing& drawing_;
    double pin_, widest_ = 0;
    std::vector<double> half_;                        ///< by element: its groove's, 0 of areas
    std::vector<std::optional<BandedRegion>> areas_;  ///< made when asked for
    std::vector<Border> borders_;
    std::vector<int> owner_;  ///< by segment
    std::optional<SegmentSquares> squares_;
    std::size_t looked_at_ = 0;
};

}  // namespace

bool find_gaps(const Drawing& drawing, const Robot& robot, std::vector<Detail>& details) {
    return Finder(drawing, robot).find(details);
}

}  // namespace strandline::legibility
