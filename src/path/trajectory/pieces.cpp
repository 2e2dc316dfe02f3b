#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "path/trajectory/speeds.hpp"
#include "path/trajectory/timer.hpp"
#include "path/trajectory/trajectory.hpp"

namespace strandline::trajectory {

/// A stretch on its own: its states, and its speeds as they were last asked for. Speeds are squared (u).
class Pieces::Timed {
  public:
    Timed(const Stretch& stretch, const Robot& robot, const Options& options) : legs_(stretch.legs) {
        for (const Leg& leg : *legs_) {
            if (leg.motion == Motion::pivot) {
                if (turns(leg)) goes_.push_back({{&leg, {leg.path.back()}}, Before::stands});
                continue;
            }
            for (Part& part : parts_of(leg, options.step)) {
                if (part.states.back().s <= 0) continue;
                goes_.push_back({std::move(part), Before::moves});
            }
        }
        for (std::size_t i = 1; i < goes_.size(); ++i) goes_[i].before = between(goes_[i - 1], goes_[i]);
        for (const Go& go : goes_) {
            if (go.pivots()) continue;
            const double limit = go.part.leg->motion == Motion::draw ? robot.speed : robot.travel_speed;
            const std::vector<RobotState>& at = go.part.states;
            for (std::size_t i = 0; i + 1 < at.size(); ++i)
                intervals_.push_back(
                    interval_of(at[i + 1].s - at[i].s, at[i].curvature, at[i + 1].curvature, limit));
        }
    }
    bool empty() const { return goes_.empty(); }
    /// What happens where this one ends and that one begins.
    enum class Before { moves, stands, dwells };
    Before before(const Timed& next) const { return between(goes_.back(), next.goes_.front()); }
    double first_cap(const Robot& robot) const { return cap(intervals_.front(), robot); }
    RobotState end() const { return goes_.back().part.states.back(); }

    /// From u at its start to the u that is reached at its end, slowing down not thought of yet.
    double forward(double start, const Robot& robot) {
        if (rising_.empty() || rising_.front() != start) {
            rising_.assign(1, start);
            piece_.reset();
            walk([&](std::size_t, const Interval& at, bool stands, const Interval* next) {
                const double u = std::min(cap(at, robot), reached(rising_.back(), at, robot));
                rising_.push_back(stands ? 0 : next ? std::min(u, cap(*next, robot)) : u);
            });
        }
        return rising_.back();
    }
    /// From u at its end to that at its start.
    double backward(double end, const Robot& robot) {
        if (speeds_.empty() || !piece_ || end_ != end) {
            piece_.reset();
            end_ = end;
            speeds_ = rising_;
            speeds_.back() = end;
            for (std::size_t i = intervals_.size(); i-- > 0;)
                speeds_[i] = std::min(speeds_[i], reached(speeds_[i + 1], intervals_[i], robot));
        }
        return speeds_.front();
    }
    /// After both. `dwells`: it stands at its end until the wheels are turned.
    std::shared_ptr<const Piece> piece(const std::vector<int>& pins, bool dwells, const Robot& robot,
                                       const Options& options) {
        if (piece_ && pins_ == pins && dwells_ == dwells) return piece_;
        pins_ = pins;
        dwells_ = dwells;
        auto piece = std::make_shared<Piece>();
        double t = 0;
        std::size_t at = 0;
        const auto add = [&](const Leg& leg, const RobotState& state, double speed) {
            const int down = leg.motion == Motion::draw ? pins[static_cast<std::size_t>(leg.stroke)] : 0;
            piece->samples.push_back(sample_at(robot, state, t, leg.motion, leg.stroke, down, speed));
        };
        const auto dwell = [&](const Go& go) {
            add(*go.part.leg, go.part.states.back(), 0);
            t += options.dwell;
        };
        for (std::size_t g = 0; g < goes_.size(); ++g) {
            const Go& go = goes_[g];
            if (g > 0 && go.before == Before::dwells) dwell(goes_[g - 1]);
            if (go.pivots()) {
                add_pivot(piece->samples, *go.part.leg, robot, t);
                continue;
            }
            for (std::size_t i = 0; i + 1 < go.part.states.size(); ++i, ++at) {
                const double here = std::sqrt(speeds_[at]), next = std::sqrt(speeds_[at + 1]);
                add(*go.part.leg, go.part.states[i], signed_speed(here, go.part.back));
                t += 2 * intervals_[at].length / (here + next);
            }
        }
        if (dwells) dwell(goes_.back());
        const Leg& last = *goes_.back().part.leg;
        const double leaves = last.motion == Motion::pivot ? 0 : std::sqrt(speeds_.back());
        piece->end = sample_at(robot, goes_.back().part.states.back(), t, Motion::connect, -1, 0,
                               signed_speed(leaves, goes_.back().part.back));
        piece_ = std::move(piece);
        return piece_;
    }

    bool used = false;

  private:
    struct Go {
        Part part;  ///< of a turn on the spot: the state after it
        Before before;
        bool pivots() const { return part.leg->motion == Motion::pivot; }
    };
    static Before between(const Go& last, const Go& next) {
        if (last.pivots() || next.pivots()) return Before::stands;
        return stands_between(last.part, next.part) ? Before::dwells : Before::moves;
    }
    /// Interval by interval: whether the robot stands at its end, and the one that it rolls on into.
    template <class See>
    void walk(const See& see) const {
        std::size_t at = 0;
        for (std::size_t g = 0; g < goes_.size(); ++g) {
            if (goes_[g].pivots()) continue;
            const std::size_t count = goes_[g].part.states.size() - 1;
            for (std::size_t i = 0; i < count; ++i, ++at) {
                const bool last = i + 1 == count, ends = last && g + 1 == goes_.size();
                const bool stands = last && !ends && goes_[g + 1].before != Before::moves;
                see(at, intervals_[at], stands,
                    at + 1 < intervals_.size() && !ends && !stands ? &intervals_[at + 1] : nullptr);
            }
        }
    }

    std::shared_ptr<const std::vector<Leg>> legs_;
    std::vector<Go> goes_;
    std::vector<Interval> intervals_;
    std::vector<double> rising_, speeds_;
    double end_ = 0;
    bool dwells_ = false;
    std::vector<int> pins_;
    std::shared_ptr<const Piece> piece_;
};

std::vector<Sample> joined(const std::vector<Placed>& pieces) {
    std::size_t count = 0;
    for (const Placed& placed : pieces) count += placed.piece->samples.size();
    std::vector<Sample> samples;
    samples.reserve(count);
    for (const Placed& placed : pieces)
        for (const Sample& sample : placed.piece->samples) {
            samples.push_back(sample);
            samples.back().t += placed.t;
            if (sample.stroke >= 0) samples.back().stroke += placed.stroke;
        }
    return samples;
}

std::vector<Placed> Pieces::timed(const std::vector<Stretch>& stretches, const std::vector<Stroke>& strokes,
                                  const Robot& robot, const Options& options) {
    if (robot != robot_ || options.step != options_.step || options.dwell != options_.dwell) kept_.clear();
    robot_ = robot;
    options_ = options;
    for (auto& [legs, timed] : kept_) timed->used = false;
    struct Of {
        std::shared_ptr<Timed> timed;
        int stroke;
        std::vector<int> pins;
        Timed::Before before;  ///< it, where the one before ends
    };
    std::vector<Of> row;
    for (const Stretch& stretch : stretches) {
        std::shared_ptr<Timed>& known = kept_[stretch.legs.get()];
        std::shared_ptr<Timed> timed = known;
        // one that is driven twice is begun and left at two speeds
        if (!timed || timed->used) timed = std::make_shared<Timed>(stretch, robot, options);
        if (!known) known = timed;
        timed->used = true;
        if (timed->empty()) continue;
        int last = -1;
        for (const Leg& leg : *stretch.legs) last = std::max(last, leg.stroke);
        std::vector<int> pins;
        for (int k = 0; k <= last; ++k)
            pins.push_back(strokes[static_cast<std::size_t>(stretch.stroke + k)].pins);
        const auto before = row.empty() ? Timed::Before::stands : row.back().timed->before(*timed);
        row.push_back({std::move(timed), stretch.stroke, std::move(pins), before});
    }
    std::erase_if(kept_, [](const auto& entry) { return !entry.second->used; });
    if (row.empty()) return {};
    const auto rolls_on = [&](std::size_t next) {
        return next < row.size() && row[next].before == Timed::Before::moves;
    };
    std::vector<double> reached(row.size());  // at its end, with what the next one allows at its start
    double u = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
        u = row[k].timed->forward(rolls_on(k) ? u : 0, robot);
        u = rolls_on(k + 1) ? std::min(u, row[k + 1].timed->first_cap(robot)) : 0;
        reached[k] = u;
    }
    for (std::size_t k = row.size(); k-- > 0;)
        u = row[k].timed->backward(rolls_on(k + 1) ? std::min(u, reached[k]) : 0, robot);

    std::vector<Placed> placed;
    double t = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
        const bool dwells = k + 1 < row.size() && row[k + 1].before == Timed::Before::dwells;
        auto piece = row[k].timed->piece(row[k].pins, dwells, robot, options);
        if (k == 0)
            if (const auto stands = waiting_before(piece->samples.front(), robot)) {
                Piece wait{{*stands}, piece->samples.front()};
                wait.end.t = t = robot.lift_delay;
                placed.push_back({std::make_shared<const Piece>(std::move(wait)), 0, 0});
            }
        const double lasts = piece->end.t;
        placed.push_back({std::move(piece), t, row[k].stroke});
        t += lasts;
    }
    Sample over = sample_at(robot, row.back().timed->end(), 0, Motion::connect, -1, 0, 0);
    over.mask = 0;
    placed.push_back({std::make_shared<const Piece>(Piece{{over}, over}), t, 0});
    return placed;
}

}  // namespace strandline::trajectory
