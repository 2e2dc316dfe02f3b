// Passes that keep off raked sand.
#include "path/fill/keep_off.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::fill {
namespace {

// Shares of the rake's width, or lengths in widths.
constexpr double beside =
    0.545;                      // half a width and half the diagonal of the raster on which fills are judged
constexpr double step = 0.125;  // between places looked at
constexpr double fresh = 1, finished = 2.5;  // of travel: sand is crossed freely before, kept off after
constexpr double steepest = 1.5;             // how fast a push may grow along the line
constexpr double least_push = 0.01;          // what raises no notice
constexpr double farthest = 0.6;             // a push: more leads round something
constexpr double enough = 0.97;              // of the distance to be kept
constexpr double astride = 0.02;             // nearer than this there is no side to be pushed to
constexpr double thinning = 1 / 200.0;
constexpr int most_pushes = 4;
constexpr double narrow = 0.5;       // mouth of a tip, also as a share of its length
constexpr double nearly_all = 0.85;  // of a tip's sand

}  // namespace

Trail::Trail(Lattice lattice, const Regions& room, const Options& options)
    : lattice_(std::move(lattice)), room_(room), options_(options), width_(options.width) {
    const double cells = static_cast<double>(lattice_.inside.size());
    watched_ = !options.masked && cells > 0 &&
               cells * lattice_.cell * lattice_.cell < largest_fine * width_ * width_;
}

std::uint64_t Trail::cell(Point p) const {
    const auto part = [&](double x) {
        return static_cast<std::uint64_t>(
            static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(x / width_))));
    };
    return part(p.x) << 32U | part(p.y);
}

void Trail::enter(const Polyline& line, double travelled, Edges& edges) const {
    if (line.size() < 2) return;
    const double whole = length(line);
    const End start{line.front(), normalized(line[0] - line[1])};
    const End end{line.back(), normalized(line.back() - line[line.size() - 2])};
    double s = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double long_ = distance(line[i - 1], line[i]);
        const int parts = std::max(1, static_cast<int>(std::ceil(long_ / width_)));
        for (int k = 0; k < parts; ++k) {
            Edge edge{between(line[i - 1], line[i], static_cast<double>(k) / parts),
                      between(line[i - 1], line[i], static_cast<double>(k + 1) / parts),
                      travelled + s + long_ * k / parts,
                      {},
                      {}};
            if (s + long_ * k / parts < width_) edge.start = start;
            if (whole - s - long_ * (k + 1) / parts < width_) edge.end = end;
            const auto number = static_cast<std::uint32_t>(edges.all.size());
            edges.all.push_back(edge);
            const double reach = beside * width_;
            const Box box = grown(including(including({}, edge.from), edge.to), reach);
            for (double x = std::floor(box.low.x / width_); x <= std::floor(box.high.x / width_); ++x)
                for (double y = std::floor(box.low.y / width_); y <= std::floor(box.high.y / width_); ++y)
                    edges.near[cell({(x + 0.5) * width_, (y + 0.5) * width_})].push_back(number);
        }
        s += long_;
    }
}

std::optional<Trail::Near> Trail::near(const Edges& own, Point p, double travelled) const {
    std::optional<Near> nearest;
    for (const Edges* edges : {&raked_, &own}) {
        const auto here = edges->near.find(cell(p));
        if (here == edges->near.end()) continue;
        for (const std::uint32_t number : here->second) {
            const Edge& edge = edges->all[number];
            if (travelled - edge.travelled < fresh * width_) continue;
            const Point u = edge.to - edge.from;
            const double uu = dot(u, u), t = uu > 0 ? dot(p - edge.from, u) / uu : 0;
            if (dot(p - edge.start.at, edge.start.beyond) > 0 || dot(p - edge.end.at, edge.end.beyond) > 0)
                continue;
            const double share = std::clamp(t, 0.0, 1.0);
            const double lag = travelled - edge.travelled - share * std::sqrt(uu);
            const double keep =
                beside * width_ * std::clamp((lag / width_ - fresh) / (finished - fresh), 0.0, 1.0);
            const Point at = edge.from + share * u;
            const double away = distance(p, at);
            if (away < keep && (!nearest || away - keep < nearest->distance - nearest->keep))
                nearest = Near{at, away, keep};
        }
    }
    return nearest;
}

Polyline Trail::kept_off(const Polyline& line) const {
    if (!watched_) return line;
    struct Place {
        Point at, pushed;
        double s = 0, push = 0;
        bool corner = false, squeezed = false, dropped = false;
    };
    std::vector<Place> places;
    double s = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0) {
            const double long_ = distance(line[i - 1], line[i]);
            const int parts = static_cast<int>(std::ceil(long_ / (step * width_)));
            for (int k = 1; k < parts; ++k) {
                const double share = static_cast<double>(k) / parts;
                places.push_back({between(line[i - 1], line[i], share), {}, s + share * long_});
            }
            s += long_;
        }
        places.push_back({line[i], {}, s, 0, true});
    }
    const double start = travelled_ + (end_ ? distance(*end_, line.front()) : 0);
    Edges own;
    enter(line, start, own);

    bool any = false;
    for (Place& place : places) {
        const double travelled = start + place.s;
        place.pushed = place.at;
        std::optional<Near> obstacle = near(own, place.at, travelled);
        for (int k = 0; obstacle && k < most_pushes; ++k) {
            if (obstacle->distance < std::min(astride * width_, obstacle->keep / 2)) break;
            place.pushed = obstacle->at + obstacle->keep / obstacle->distance * (place.pushed - obstacle->at);
            obstacle = near(own, place.pushed, travelled);
            if (obstacle && obstacle->distance > enough * obstacle->keep) obstacle.reset();
        }
        place.squeezed =
            obstacle || (place.pushed != place.at && (!room_.contains(place.pushed) ||
                                                      distance(place.at, place.pushed) > farthest * width_));
        if (place.squeezed) place.pushed = place.at;
        place.push = distance(place.at, place.pushed);
        any = any || place.squeezed || place.push > least_push * width_;
    }
    if (!any) return line;

    // A tip into what is raked anyhow is cut off.
    for (std::size_t i = 0, j = 0; i < places.size(); i = ++j) {
        j = i;
        if (!places[i].squeezed) continue;
        while (j + 1 < places.size() && places[j + 1].squeezed) ++j;
        if (i == 0 || j + 1 == places.size()) continue;
        const double mouth = distance(places[i - 1].pushed, places[j + 1].pushed);
        if (mouth > std::max(narrow * width_, narrow * (places[j].s - places[i].s))) continue;
        int raked_places = 0, all = 0;
        for (std::size_t k = i; k <= j; ++k) {
            const Point ahead = normalized(places[std::min(k + 1, j)].at - places[k].at);
            for (const double off : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
                ++all;
                if (raked(places[k].at + off * width_ * left_normal(ahead))) ++raked_places;
            }
        }
        if (raked_places < nearly_all * all) continue;
        for (std::size_t k = i; k <= j; ++k) places[k].dropped = true;
    }
    std::erase_if(places, [](const Place& place) { return place.dropped; });

    const auto limit = [&](Place& place, const Place& beside_it) {
        place.push = std::min(place.push, beside_it.push + steepest * std::abs(place.s - beside_it.s));
    };
    for (std::size_t i = 1; i < places.size(); ++i) limit(places[i], places[i - 1]);
    for (std::size_t i = places.size() - 1; i-- > 0;) limit(places[i], places[i + 1]);

    Polyline kept, stretch;
    const auto close = [&] {
        const Polyline plain = thinned(stretch, thinning * width_);
        kept.insert(kept.end(), plain.begin(), plain.end());
        stretch.clear();
    };
    for (const Place& place : places) {
        const double whole = distance(place.at, place.pushed);
        if (whole > 0 && place.push > 0) {
            stretch.push_back(between(place.at, place.pushed, place.push / whole));
            continue;
        }
        if (!stretch.empty()) close();
        if (place.corner) kept.push_back(place.at);
    }
    if (!stretch.empty()) close();
    return without_duplicates(kept, least_push * width_);
}

bool Trail::raked(Point p) const {
    return is_raked(lattice_, p) || (!latest_.empty() && distance_to(latest_, p) < width_ / 2);
}

void Trail::add(const Polyline& line) {
    if (line.size() < 2) return;
    if (!watched_) {
        rake(lattice_, line, options_);
        end_ = line.back();
        return;
    }
    if (end_) travelled_ += distance(*end_, line.front());
    enter(line, travelled_, raked_);
    const double long_ = length(line), finished_to = std::max(0.0, long_ - fresh * width_);
    rake(lattice_, latest_, options_);
    if (finished_to > 0) rake(lattice_, slice(line, 0, finished_to), options_);
    latest_ = slice(line, finished_to, long_);
    travelled_ += long_;
    end_ = line.back();
}

}  // namespace strandline::fill
