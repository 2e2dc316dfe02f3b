#include "path/tour/bound.hpp"

#include <algorithm>
#include <limits>

namespace strandline::tour {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Rounds of the ascent; the step is halved whenever `patience` rounds brought nothing. More rounds gain less
/// than 0.1 %.
constexpr int ascent_rounds = 240, patience = 12;
/// Dropping vertices raises the bound, which drops more: two or three times bring nearly all of it.
constexpr int drop_rounds = 4;

std::size_t at(int i) { return static_cast<std::size_t>(i); }
bool has(std::uint64_t mask, int stop) { return (mask >> stop) & 1U; }

}  // namespace

Bound::Bound(Route& route, double upper, double tolerance)
    : route_(&route), stops_(route.stops() + 1), width_(2 * stops_) {
    price_.assign(at(width_), 0);
    for (int round = 0; round < drop_rounds; ++round) {
        measure();
        ascend(upper);
        if (!drop(upper + tolerance)) break;
    }
    measure();
    merge();
    root_ = first_leg(nullptr) + tree(route.all);
}

void Bound::measure() {
    const Route& route = *route_;
    const int end = stops_ - 1;
    gap_.assign(at(width_ * width_), infinite);
    reach_.assign(route.options.size() * at(width_), infinite);
    start_.assign(at(width_), infinite);
    // Where each terminal is: the two ends of a line are known from any of its options.
    struct Spot {
        int terminal;
        Point at;
    };
    std::vector<Spot> spots;
    for (int s = 0; s < end; ++s) {
        if (!has(route.all, s)) continue;
        for (int o = route.first[at(s)]; o < route.first[at(s + 1)]; ++o) {
            const Option& option = route.options[at(o)];
            spots.push_back({2 * s, option.backward ? option.out : option.in});
            if (!route.polygon[at(s)]) {
                spots.push_back({2 * s + 1, option.backward ? option.in : option.out});
                break;
            }
        }
    }
    for (std::size_t o = 0; o < route.options.size(); ++o) {
        for (const Spot& spot : spots) {
            double& reach = reach_[o * at(width_) + at(spot.terminal)];
            reach = std::min(reach, distance(route.options[o].out, spot.at));
        }
        reach_[o * at(width_) + at(2 * end)] = route.to ? distance(route.options[o].out, *route.to) : 0;
    }
    for (const Spot& a : spots) {
        for (const Spot& b : spots) {
            if (a.terminal / 2 >= b.terminal / 2) continue;
            double& gap = gap_[at(a.terminal * width_ + b.terminal)];
            gap = std::min(gap, distance(a.at, b.at));
        }
        double& last = gap_[at(a.terminal * width_ + 2 * end)];
        last = std::min(last, route.to ? distance(a.at, *route.to) : 0);
        start_[at(a.terminal)] =
            std::min(start_[at(a.terminal)], route.from ? distance(*route.from, a.at) : 0);
    }
}

void Bound::merge() {
    merged_.assign(at(stops_ * stops_), infinite);
    touched_.assign(at(stops_ * stops_), 0);
    for (int s = 0; s < stops_; ++s)
        for (int u = s + 1; u < stops_; ++u) {
            double best = infinite;
            int touched = 0;
            for (int i = 0; i < 4; ++i) {
                const int a = 2 * s + i / 2, b = 2 * u + i % 2;
                if (const double d = gap_[at(a * width_ + b)] + price_[at(a)] + price_[at(b)]; d < best) {
                    best = d;
                    touched = i;
                }
            }
            merged_[at(s * stops_ + u)] = merged_[at(u * stops_ + s)] = best;
            touched_[at(s * stops_ + u)] = touched;
            touched_[at(u * stops_ + s)] = (touched % 2) * 2 + touched / 2;
        }
}

/// Prim from the end over the stops of the mask.
double Bound::spanned(std::uint64_t mask, std::vector<int>* degrees) const {
    double least[64];
    int from[64], open[64];
    int count = 0;
    const int end = stops_ - 1;
    for (int s = 0; s < end; ++s)
        if (has(mask, s)) {
            least[s] = merged_[at(end * stops_ + s)];
            from[s] = end;
            open[count++] = s;
        }
    double sum = 0;
    while (count > 0) {
        int best = 0;
        for (int k = 1; k < count; ++k)
            if (least[open[k]] < least[open[best]]) best = k;
        const int s = open[best];
        open[best] = open[--count];
        sum += least[s];
        if (degrees) {
            const int touched = touched_[at(from[s] * stops_ + s)];
            ++(*degrees)[at(2 * from[s] + touched / 2)];
            ++(*degrees)[at(2 * s + touched % 2)];
        }
        for (int k = 0; k < count; ++k)
            if (const double d = merged_[at(s * stops_ + open[k])]; d < least[open[k]])
                least[open[k]] = d, from[open[k]] = s;
    }
    return sum;
}

double Bound::back(std::uint64_t mask) const {
    double sum = price_[at(2 * (stops_ - 1))];
    for (int s = 0; s < stops_ - 1; ++s)
        if (has(mask, s))
            sum += route_->polygon[at(s)] ? 2 * price_[at(2 * s)] : price_[at(2 * s)] + price_[at(2 * s + 1)];
    return sum;
}

double Bound::first_leg(int* terminal) const {
    double best = infinite;
    for (int t = 0; t < width_ - 2; ++t)
        if (const double d = start_[at(t)] + price_[at(t)]; d < best) {
            best = d;
            if (terminal) *terminal = t;
        }
    return best;
}

double Bound::tree(std::uint64_t mask) const { return spanned(mask, nullptr) - back(mask); }

std::vector<double> Bound::reach(int first, int last) const {
    std::vector<double> least(at(width_), infinite);
    for (int o = first; o < last; ++o)
        for (int t = 0; t < width_; ++t)
            least[at(t)] = std::min(least[at(t)], reach_[at(o) * at(width_) + at(t)] + price_[at(t)]);
    return least;
}

double Bound::first_leg(const std::vector<double>& reach, std::uint64_t mask) const {
    double best = infinite;
    for (int s = 0; s < stops_ - 1; ++s)
        if (has(mask, s)) best = std::min({best, reach[at(2 * s)], reach[at(2 * s + 1)]});
    return best;
}

void Bound::ascend(double upper) {
    std::vector<double> best_price = price_;
    std::vector<int> degrees(at(width_));
    double best = -infinite, share = 1;
    for (int round = 0, idle = 0; round < ascent_rounds; ++round) {
        merge();
        std::fill(degrees.begin(), degrees.end(), 0);
        int entered = 0;
        const double value = first_leg(&entered) + spanned(route_->all, &degrees) - back(route_->all);
        ++degrees[at(entered)];
        if (value > best) {
            best = value;
            best_price = price_;
            idle = 0;
        } else if (++idle == patience) {
            share /= 2;
            idle = 0;
        }
        double norm = 0;
        for (int s = 0; s < stops_; ++s) {
            if (s < stops_ - 1 && !has(route_->all, s)) continue;
            const bool line = s < stops_ - 1 && !route_->polygon[at(s)];
            degrees[at(2 * s)] -= line || s == stops_ - 1 ? 1 : 2;
            if (line) --degrees[at(2 * s + 1)];
            norm += degrees[at(2 * s)] * degrees[at(2 * s)] + degrees[at(2 * s + 1)] * degrees[at(2 * s + 1)];
        }
        if (norm == 0 || best >= upper) break;  // the tree is a path: nothing above it
        const double step = share * (upper - value) / norm;
        for (int t = 0; t < width_; ++t) price_[at(t)] += step * degrees[at(t)];
    }
    price_ = best_price;
    merge();
}

bool Bound::drop(double limit) {
    Route& route = *route_;
    std::vector<Option> kept;
    std::vector<int> first;
    const std::vector<double> merged = merged_, start = start_;
    for (int s = 0; s < stops_ - 1; ++s) {
        first.push_back(static_cast<int>(kept.size()));
        for (int o = route.first[at(s)]; o < route.first[at(s + 1)]; ++o) {
            bool useful = true;
            if (route.polygon[at(s)] && has(route.all, s) &&
                route.first[at(s + 1)] - route.first[at(s)] > 1) {
                // The same bound with the polygon shrunk to this vertex.
                for (int u = 0; u < stops_; ++u) {
                    if (u == s) continue;
                    const double* reach = &reach_[at(o) * at(width_) + at(2 * u)];
                    const double d =
                        std::min(reach[0] + price_[at(2 * u)], reach[1] + price_[at(2 * u + 1)]) +
                        price_[at(2 * s)];
                    merged_[at(s * stops_ + u)] = merged_[at(u * stops_ + s)] = d;
                }
                start_[at(2 * s)] = route.from ? distance(*route.from, route.options[at(o)].in) : 0;
                useful = first_leg(nullptr) + tree(route.all) <= limit;
            }
            if (useful) kept.push_back(route.options[at(o)]);
        }
        merged_ = merged;
        start_ = start;
    }
    first.push_back(static_cast<int>(kept.size()));
    const bool any = kept.size() < route.options.size();
    route.options = std::move(kept);
    route.first = std::move(first);
    return any;
}

}  // namespace strandline::tour
