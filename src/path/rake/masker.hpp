#pragma once
// Private to the room: which pins are down where. Each pin for itself, against what is raked by then. A step
// is what a rake does in one go with one mask: anything with for_samples_in, for_runs_in, middle_of and
// `arc`.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "math/raster/raster.hpp"
#include "path/rake/track.hpp"

namespace strandline::rake {

inline constexpr int samples_a_pin = 4;  // across; the cells are as large
// What a cell under a pin is worth: unraked sand that nobody reaches later is 1.
inline constexpr double again = -0.5;  // finished sand
inline constexpr double deferred =
    -0.2;  // unraked, and a later pass comes by: left to the last, no path crosses it finished
inline constexpr double pass_lag =
    1.0;  // widths of travel after which sand is finished: as the account has it
inline constexpr double least_blip = 0.05;  // widths: a pin is not moved for less
inline constexpr double look_ahead = 0.35;  // widths: twice this must stay below pass_lag
inline constexpr float never = -std::numeric_limits<float>::infinity();

struct Sand {
    float raked = never, visited = never;  // arc length, cells
    std::uint8_t visits = 0;               // that are still to come
    bool inside = false;
};

/// What a step is worth, by pin, leftmost first.
using Values = std::array<float, 32>;

/// Decides the masks of steps (PinStep or BarStep) in their order, against the sand as raked by then.
template <class Step>
class Masker {
  public:
    using Steps = std::vector<Step>;
    Masker(const Regions& regions, const Raster& raster, const Rake& rake)
        : raster_(raster),
          pins_(rake.pins),
          pin_(rake.width / rake.pins / raster.cell),
          outside_(-rake.spill_price),
          lag_(static_cast<float>(pass_lag * rake.width / raster.cell)),
          sand_(raster.size()) {
        for (const Run& run : runs_inside(raster, regions))
            for (int column = run.first; column < run.end; ++column)
                sand_[raster.index(column, run.row)].inside = true;
    }
    /// Counts the visits that each cell will have, by pins that stay inside; gives their masks by step.
    std::vector<unsigned> foresee(const Steps& steps);
    void forget_visits() {
        for (Sand& sand : sand_) sand.visited = never;
    }
    /// The mask of each step; rakes with them.
    std::vector<unsigned> masks_of(const Steps& steps, const std::vector<unsigned>& visitors);

  private:
    const Sand& at(Point p) const {
        return sand_[raster_.index(static_cast<int>(p.x + 0.5), static_cast<int>(p.y + 0.5))];
    }
    std::vector<Bar> bars(unsigned mask) const { return bars_of(mask, pins_, pins_ * pin_); }
    Values values(const Step& step) const;
    void visit(const Step& step, unsigned mask, int change);
    void rake(const Step& step, unsigned mask);

    const Raster& raster_;
    int pins_;
    double pin_;  // cells
    double outside_;
    float lag_;
    std::vector<Sand> sand_;
};

template <class Step>
Values Masker<Step>::values(const Step& step) const {
    Values values{};
    const float finished = static_cast<float>(step.arc) - lag_;
    const double left = pins_ * pin_ / 2, thin = pin_ / samples_a_pin;
    for_samples_in(step, left, thin, pins_ * samples_a_pin, [&](int i, Point p, double weight) {
        const Sand& sand = at(p);
        const double raked = sand.raked < finished ? again : 0;
        const double fresh = sand.visits > 0 ? deferred : 1;
        const double worth = !sand.inside ? outside_ : sand.raked == never ? fresh : raked;
        values[static_cast<std::size_t>(i / samples_a_pin)] += static_cast<float>(worth * weight);
    });
    return values;
}

template <class Step>
void Masker<Step>::visit(const Step& step, unsigned mask, int change) {
    for_runs_in(raster_, step, bars(mask), [&](const Run& run, double arc, double slope) {
        auto s = static_cast<float>(arc);
        for (std::size_t i = raster_.index(run.first, run.row); i < raster_.index(run.end, run.row);
             ++i, s += static_cast<float>(slope)) {
            Sand& sand = sand_[i];
            if (sand.visited < s - lag_) sand.visits = static_cast<std::uint8_t>(sand.visits + change);
            sand.visited = std::max(sand.visited, s);
        }
    });
}

template <class Step>
void Masker<Step>::rake(const Step& step, unsigned mask) {
    for_runs_in(raster_, step, bars(mask), [&](const Run& run, double arc, double slope) {
        auto s = static_cast<float>(arc);
        for (std::size_t i = raster_.index(run.first, run.row); i < raster_.index(run.end, run.row);
             ++i, s += static_cast<float>(slope))
            sand_[i].raked = std::max(sand_[i].raked, s);
    });
}

template <class Step>
std::vector<unsigned> Masker<Step>::foresee(const Steps& steps) {
    std::vector<unsigned> visitors;
    const double half = pins_ * pin_ / 2;
    for (const Step& step : steps) {
        // Looked at where pins meet, and just within the ends of the rake: a pin stays inside if both its
        // sides do.
        const auto [middle, left] = middle_of(step);
        unsigned mask = 0;
        bool before = false;
        for (int side = 0; side <= pins_; ++side) {
            const double offset = std::clamp(half - side * pin_, 0.5 - half, half - 0.5);
            const bool inside = at(middle + offset * left).inside;
            if (side > 0) mask = mask << 1U | (before && inside ? 1U : 0U);
            before = inside;
        }
        visitors.push_back(mask);
    }
    for_stretches(steps, visitors, 0, steps.size(),
                  [&](const Step& stretch, unsigned mask) { visit(stretch, mask, 1); });
    return visitors;
}

/// The states of one pin that are worth most in sum, moves of the pin counted: dynamic programming over its
/// two states.
inline void decide(const std::vector<Values>& values, std::size_t pin, bool& down, float move,
                   std::span<unsigned> masks, unsigned bit) {
    std::vector<std::array<bool, 2>> from(values.size());
    std::array<float, 2> best{down ? -move : 0.0F, down ? 0.0F : -move};
    for (std::size_t k = 0; k < values.size(); ++k) {
        // best[state]: of everything before step k, in that state from k on.
        if (k > 0) {
            from[k] = {best[1] - move > best[0], best[1] >= best[0] - move};
            best = {from[k][0] ? best[1] - move : best[0], from[k][1] ? best[1] : best[0] - move};
        }
        best[1] += values[k][pin];
    }
    bool state = best[1] > best[0];
    for (std::size_t k = values.size(); k-- > 0;) {
        if (k < masks.size() && state) masks[k] |= bit;
        if (k + 1 == masks.size()) down = state;
        if (k > 0) state = from[k][state ? 1 : 0];
    }
}

template <class Step>
std::vector<unsigned> Masker<Step>::masks_of(const Steps& steps, const std::vector<unsigned>& visitors) {
    const auto ahead = static_cast<double>(lag_) * look_ahead / pass_lag;  // cells
    const auto move = static_cast<float>(least_blip * static_cast<double>(lag_) * pin_ / 2);
    std::vector<Values> values;  // of the steps that are not settled yet
    std::vector<bool> down(static_cast<std::size_t>(pins_), false);
    std::vector<unsigned> masks(steps.size(), 0);
    std::size_t settled = 0, visited = 0;
    const auto settle = [&](std::size_t count) {
        for (std::size_t pin = 0; pin < down.size(); ++pin) {
            bool state = down[pin];
            decide(values, pin, state, move, std::span(masks).subspan(settled, count),
                   1U << (down.size() - 1 - pin));
            down[pin] = state;
        }
        for_stretches(steps, masks, settled, settled + count,
                      [&](const Step& stretch, unsigned mask) { rake(stretch, mask); });
        settled += count;
        values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    };
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (k == visited)
            visited = for_first_stretch(steps, visitors, k, steps.size(),
                                        [&](const Step& s, unsigned mask) { visit(s, mask, -1); });
        values.push_back(this->values(steps[k]));
        if (steps[k].arc - steps[settled].arc < 2 * ahead) continue;
        std::size_t half = settled;
        while (steps[half].arc - steps[settled].arc < ahead) ++half;
        settle(half - settled);
    }
    settle(values.size());
    return masks;
}

}  // namespace strandline::rake
