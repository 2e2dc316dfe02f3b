// Which pins are down where: each pin for itself, against what is raked by then.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "path/rake/pin_steps.hpp"

namespace strandline::rake {
namespace {

constexpr int samples_a_pin = 4;  // across; the cells are as large
constexpr double step_cells = 1;  // longest step
// What a cell under a pin is worth: unraked sand that nobody reaches later is 1.
constexpr double again = -0.5;    // finished sand
constexpr double outside = -4.0;  // beside the area
constexpr double deferred =
    -0.2;  // unraked, and a later pass comes by: left to the last, no path crosses it finished
constexpr double pass_lag = 1.0;     // widths of travel after which sand is finished: as the account has it
constexpr double least_blip = 0.05;  // widths: a pin is not moved for less
constexpr double look_ahead = 0.35;  // widths: twice this must stay below pass_lag
constexpr float never = -std::numeric_limits<float>::infinity();

struct Sand {
    float raked = never, visited = never;  // arc length, cells
    std::uint8_t visits = 0;               // that are still to come
    bool inside = false;
};

/// What a step is worth, by pin, leftmost first.
using Values = std::array<float, 32>;

class Masker {
  public:
    Masker(const Regions& regions, const Raster& raster, const Rake& rake)
        : raster_(raster),
          pins_(rake.pins),
          pin_(rake.width / rake.pins / raster.cell),
          lag_(static_cast<float>(pass_lag * rake.width / raster.cell)),
          sand_(raster.size()) {
        for (const Run& run : runs_inside(raster, regions))
            for (int column = run.first; column < run.end; ++column)
                sand_[raster.index(column, run.row)].inside = true;
    }
    /// Counts the visits that each cell will have, by pins that stay inside; gives their masks by step.
    std::vector<unsigned> foresee(const std::vector<PinStep>& steps);
    void forget_visits() {
        for (Sand& sand : sand_) sand.visited = never;
    }
    PinSpans masks_of(const std::vector<PinStep>& steps, const std::vector<unsigned>& visitors);

  private:
    const Sand& at(Point p) const {
        return sand_[raster_.index(static_cast<int>(p.x + 0.5), static_cast<int>(p.y + 0.5))];
    }
    std::vector<Bar> bars(unsigned mask) const { return bars_of(mask, pins_, pins_ * pin_); }
    /// what(pin, sand, weight) for sample points that tile the step's sand: each pin's next to each other.
    template <class What>
    void sample(const PinStep& step, What what) const;
    Values values(const PinStep& step) const;
    void visit(const PinStep& step, unsigned mask, int change);
    void rake(const PinStep& step, unsigned mask);

    const Raster& raster_;
    int pins_;
    double pin_;  // cells
    float lag_;
    std::vector<Sand> sand_;
};

template <class What>
void Masker::sample(const PinStep& step, What what) const {
    const double left = pins_ * pin_ / 2, thin = pin_ / samples_a_pin;
    const auto across = [&](Point middle, Point ahead) {
        const Point aside = thin * left_normal(ahead);
        Point p = middle + (left / thin - 0.5) * aside;
        for (int pin = 0; pin < pins_; ++pin)
            for (int k = 0; k < samples_a_pin; ++k, p = p - aside) what(pin, at(p), step.length * thin);
    };
    if (!step.corner) {
        across(step.at + step.length / 2 * step.ahead, step.ahead);
        return;
    }
    across(step.at - step.length / 2 * step.before, step.before);
    across(step.at + step.length / 2 * step.ahead, step.ahead);
    const double turn = std::atan2(cross(step.before, step.ahead), dot(step.before, step.ahead));
    const double rays = std::max(1.0, std::ceil(std::abs(turn) * left));
    for (double ray = 0.5; ray < rays; ++ray) {
        const double angle = turn * ray / rays;
        const Point side = std::cos(angle) * left_normal(step.before) - std::sin(angle) * step.before;
        for (int i = 0; i < pins_ * samples_a_pin; ++i) {
            const double offset = left - (i + 0.5) * thin;  // to the left
            if (offset * turn < 0)                          // a left turn sweeps the right
                what(i / samples_a_pin, at(step.at + offset * side),
                     std::abs(offset) * std::abs(turn) / rays * thin);
        }
    }
}

Values Masker::values(const PinStep& step) const {
    Values values{};
    const float finished = static_cast<float>(step.arc) - lag_;
    sample(step, [&](int pin, const Sand& sand, double weight) {
        const double raked = sand.raked < finished ? again : 0;
        const double fresh = sand.visits > 0 ? deferred : 1;
        const double worth = !sand.inside ? outside : sand.raked == never ? fresh : raked;
        values[static_cast<std::size_t>(pin)] += static_cast<float>(worth * weight);
    });
    return values;
}

void Masker::visit(const PinStep& step, unsigned mask, int change) {
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

void Masker::rake(const PinStep& step, unsigned mask) {
    for_runs_in(raster_, step, bars(mask), [&](const Run& run, double arc, double slope) {
        auto s = static_cast<float>(arc);
        for (std::size_t i = raster_.index(run.first, run.row); i < raster_.index(run.end, run.row);
             ++i, s += static_cast<float>(slope))
            sand_[i].raked = std::max(sand_[i].raked, s);
    });
}

std::vector<unsigned> Masker::foresee(const std::vector<PinStep>& steps) {
    std::vector<unsigned> visitors;
    const double half = pins_ * pin_ / 2;
    for (const PinStep& step : steps) {
        // Looked at where pins meet, and just within the ends of the rake: a pin stays inside if both its
        // sides do.
        const Point left = left_normal(step.ahead), middle = step.at + step.length / 2 * step.ahead;
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
                  [&](const PinStep& stretch, unsigned mask) { visit(stretch, mask, 1); });
    return visitors;
}

/// The states of one pin that are worth most in sum, moves of the pin counted: dynamic programming over its
/// two states.
void decide(const std::vector<Values>& values, std::size_t pin, bool& down, float move,
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

PinSpans Masker::masks_of(const std::vector<PinStep>& steps, const std::vector<unsigned>& visitors) {
    const auto ahead = static_cast<double>(lag_) * look_ahead / pass_lag;  // cells
    const auto move = static_cast<float>(least_blip * static_cast<double>(lag_) * pin_ / 2);
    std::vector<Values> values;  // of the steps that are not settled yet
    std::vector<bool> down(static_cast<std::size_t>(pins_), false);
    PinSpans spans;
    std::vector<unsigned> masks(steps.size(), 0);
    std::size_t settled = 0, visited = 0;
    const auto settle = [&](std::size_t count) {
        for (std::size_t pin = 0; pin < down.size(); ++pin) {
            bool state = down[pin];
            decide(values, pin, state, move, std::span(masks).subspan(settled, count),
                   1U << (down.size() - 1 - pin));
            down[pin] = state;
        }
        for_stretches(steps, masks, settled, settled + count, [&](const PinStep& stretch, unsigned mask) {
            rake(stretch, mask);
            if (!spans.empty() && spans.back().mask == mask)
                spans.back().to = stretch.to;
            else
                spans.push_back({stretch.from, stretch.to, mask});
        });
        settled += count;
        values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    };
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (k == visited)
            visited = for_first_stretch(steps, visitors, k, steps.size(),
                                        [&](const PinStep& s, unsigned mask) { visit(s, mask, -1); });
        values.push_back(this->values(steps[k]));
        if (steps[k].arc - steps[settled].arc < 2 * ahead) continue;
        std::size_t half = settled;
        while (steps[half].arc - steps[settled].arc < ahead) ++half;
        settle(half - settled);
    }
    settle(values.size());
    std::erase_if(spans, [](const PinSpan& span) { return span.mask == 0; });
    return spans;
}

}  // namespace

std::vector<PinSpans> pin_masks(const Regions& regions, const std::vector<Stroke>& strokes,
                                const std::vector<Polyline>& ways, const Rake& rake) {
    std::vector<Track> tracks;
    Box box = bounds(regions);
    for (const Stroke& stroke : strokes) {
        tracks.push_back(track_of(stroke.rake_path, rake.tolerance));
        box = united(box, bounds(tracks.back().line));
    }
    // Room for the whole rake and a cell beside it: samples need no look at the borders.
    const Raster raster = raster_over(grown(box, rake.width), rake.width / (samples_a_pin * rake.pins));
    const auto steps = pin_steps(tracks, ways, raster, step_cells);
    Masker masker(regions, raster, rake);
    std::vector<std::vector<unsigned>> visitors;
    for (const auto& of_stroke : steps) visitors.push_back(masker.foresee(of_stroke));
    masker.forget_visits();
    std::vector<PinSpans> masks;
    for (std::size_t i = 0; i < steps.size(); ++i) masks.push_back(masker.masks_of(steps[i], visitors[i]));
    return masks;
}

}  // namespace strandline::rake
