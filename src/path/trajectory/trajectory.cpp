#include "path/trajectory/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "path/trajectory/speeds.hpp"
#include "path/trajectory/timer.hpp"

namespace strandline::trajectory {
namespace {

// Radians between samples of a turn on the spot.
constexpr double pivot_step = 0.1;
// Radians turned in one step while driving.
constexpr double most_turn = 0.1;

/// Halves the step from the last of `fine` to `to` until curvature linear in between explains its headings.
void add_refined(const Leg& leg, double from, const RobotState& to, int halvings,
                 std::vector<RobotState>& fine) {
    constexpr double most_unexplained = 0.003;  // radians
    const RobotState& last = fine.back();
    const double ds = to.s - last.s, turn = wrap_angle(to.pose.heading - last.pose.heading),
                 explained = ds * (last.curvature + to.curvature) / 2;
    if (halvings > 0 && (std::abs(turn) > most_turn || std::abs(turn - explained) > most_unexplained)) {
        RobotState middle = state_at(leg.path, from + last.s + ds / 2);
        middle.s -= from;
        add_refined(leg, from, middle, halvings - 1, fine);
        add_refined(leg, from, to, halvings - 1, fine);
    } else {
        fine.push_back(to);
    }
}

std::vector<RobotState> refined(const Leg& leg, double from, const std::vector<RobotState>& even) {
    constexpr int most_halvings = 6;
    std::vector<RobotState> fine{even.front()};
    for (std::size_t i = 1; i < even.size(); ++i) add_refined(leg, from, even[i], most_halvings, fine);
    return fine;
}

/// At least two: between two stands a single interval would have no speed at either end.
int parts_in(double metres, double step) {
    return std::max(2, static_cast<int>(std::ceil(metres / step - 1e-9)));
}

/// Along one section of a leg's curve. Where it has tight bends each piece is sampled as finely as it turns:
/// between samples farther apart a bend would be tighter than both say, and driven too fast.
std::vector<RobotState> evenly(const Curve& section, double step) {
    std::vector<RobotState> states;
    const auto sample = [&](const Curve& part, double s0, double spacing) {
        for (const CurvePoint& p : sampled(part, spacing, parts_in(length(part), spacing) + 1))
            if (states.empty() || p.s > 0) states.push_back({s0 + p.s, p.pose, p.curvature});
    };
    if (max_curvature(section) * step <= most_turn) {
        sample(section, 0, step);
        return states;
    }
    Curve piece{section.start, {{}}};
    double s = 0;
    for (const Clothoid& each : section.pieces) {
        if (each.length == 0) continue;
        piece.pieces.front() = each;
        const double bend = max_curvature(piece);
        sample(piece, s, bend * step > most_turn ? most_turn / bend : step);
        piece.start = end_pose(piece);
        s += std::abs(each.length);
    }
    return states;
}

std::vector<RobotState> evenly(const Leg& leg, double from, double to, double step) {
    std::vector<RobotState> states;
    const int parts = parts_in(to - from, step);
    for (int i = 0; i <= parts; ++i) {
        RobotState state = state_at(leg.path, from + (to - from) * i / parts);
        state.s -= from;
        states.push_back(state);
    }
    return refined(leg, from, states);
}

/// Pins down between strokes.
unsigned mask_between(const Robot& robot) { return robot.lifts ? 0 : pin_mask(robot, robot.pins); }

}  // namespace

std::vector<Part> parts_of(const Leg& leg, double step) {
    std::vector<Part> parts;
    if (!leg.curve.pieces.empty()) {
        for (const Curve& section : sections(leg.curve))
            parts.push_back({&leg, evenly(section, step), backs(section.pieces.front())});
        return parts;
    }
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= leg.path.size(); ++i) {
        const bool last = i == leg.path.size();
        if (!last && leg.path[i].s > leg.path[i - 1].s) continue;
        if (i - begin >= 2) {
            Leg piece{leg.motion,
                      leg.stroke,
                      {leg.path.begin() + static_cast<std::ptrdiff_t>(begin),
                       leg.path.begin() + static_cast<std::ptrdiff_t>(i)},
                      {}};
            const double from = piece.path.front().s;
            parts.push_back({&leg, evenly(piece, from, piece.path.back().s, step)});
        }
        begin = i;
    }
    return parts;
}

void add_pivot(std::vector<Sample>& samples, const Leg& leg, const Robot& robot, double& t) {
    const RobotState& from = leg.path.front();
    const double turn = wrap_angle(leg.path.back().pose.heading - from.pose.heading);
    const int parts = std::max(2, static_cast<int>(std::ceil(std::abs(turn) / pivot_step)));
    const double part = std::abs(turn) / parts;
    const auto rate_at = [&](int i) {
        const double done = i * part, left = std::max(0.0, std::abs(turn) - done);
        return std::min(robot.turn_rate, std::sqrt(2 * robot.turn_acceleration * std::min(done, left)));
    };
    for (int i = 0; i < parts; ++i) {
        Sample sample;
        sample.t = t;
        sample.pose = {from.pose.at, wrap_angle(from.pose.heading + turn * i / parts)};
        sample.turn_rate = std::copysign(rate_at(i), turn);
        sample.rake = rake_at(robot, sample.pose);
        sample.motion = Motion::pivot;
        sample.mask = mask_between(robot);
        samples.push_back(sample);
        t += 2 * part / (rate_at(i) + rate_at(i + 1));
    }
}

bool stands_between(const Part& last, const Part& next) {
    if (last.back != next.back) return true;
    return std::abs(last.states.back().curvature - next.states.front().curvature) > same_curvature;
}

bool turns(const Leg& leg) {
    return !leg.path.empty() && wrap_angle(leg.path.back().pose.heading - leg.path.front().pose.heading) != 0;
}

Sample sample_at(const Robot& robot, const RobotState& state, double t, Motion motion, int stroke, int pins,
                 double speed) {
    Sample sample;
    sample.t = t;
    sample.pose = {state.pose.at, wrap_angle(state.pose.heading)};
    sample.curvature = state.curvature;
    sample.speed = speed;
    sample.turn_rate = speed * state.curvature;
    sample.rake = rake_at(robot, state.pose);
    sample.motion = motion;
    if (motion == Motion::draw) {
        sample.stroke = stroke;
        sample.mask = pin_mask(robot, pins);
    } else {
        sample.mask = mask_between(robot);
    }
    return sample;
}

std::optional<Sample> waiting_before(const Sample& first, const Robot& robot) {
    if (robot.lift_delay <= 0 || !robot.lifts || first.mask == 0) return std::nullopt;
    Sample stands = first;
    stands.mask = 0;
    stands.motion = Motion::lead;
    stands.stroke = -1;
    return stands;
}

namespace {

/// Gathers parts until the robot must stand, times them, and goes on. `stood_` is where it stands now:
/// whoever comes next writes the sample there (a run its first, a pivot its first, the end the last), so that
/// no instant is written twice.
class Timer {
  public:
    Timer(const std::vector<Stroke>& strokes, const Robot& robot, const Options& options)
        : strokes_(strokes), robot_(robot), options_(options) {}

    void add(const Leg& leg) {
        if (leg.motion == Motion::pivot) {
            if (!turns(leg)) return;
            stand();
            add_pivot(samples_, leg, robot_, t_);
            stood_ = leg.path.back();
            return;
        }
        for (Part& part : parts_of(leg, options_.step)) {
            if (part.states.back().s <= 0) continue;
            if (!run_.empty() && stands_between(run_.back(), part)) dwell();
            run_.push_back(std::move(part));
        }
    }

    std::vector<Sample> finished() {
        stand();
        if (stood_) samples_.push_back(sample_at(*stood_, Motion::connect, -1, 0));
        if (stood_) samples_.back().mask = 0;  // the drive is over
        return std::move(samples_);
    }

  private:
    Sample sample_at(const RobotState& state, Motion motion, int stroke, double speed) const {
        const int pins = motion == Motion::draw ? strokes_[static_cast<std::size_t>(stroke)].pins : 0;
        return trajectory::sample_at(robot_, state, t_, motion, stroke, pins, speed);
    }

    /// Stands with the pins as they are while the curvature jumps.
    void dwell() {
        const Leg& leg = *run_.back().leg;
        stand();
        samples_.push_back(sample_at(*stood_, leg.motion, leg.stroke, 0));
        t_ += options_.dwell;
    }

    /// Times everything driven since the last stand and ends in a stand.
    void stand() {
        if (run_.empty()) return;
        Course run;
        double offset = 0;
        for (const Part& part : run_) {
            const double limit = part.leg->motion == Motion::draw ? robot_.speed : robot_.travel_speed;
            for (std::size_t i = run.s.empty() ? 0 : 1; i < part.states.size(); ++i) {
                run.s.push_back(offset + part.states[i].s);
                run.curvature.push_back(part.states[i].curvature);
                if (i > 0) run.limit.push_back(limit);
            }
            offset += part.states.back().s;
        }
        const std::vector<double> speed = speeds_along(run, robot_);
        std::size_t at = 0;
        for (const Part& part : run_) {
            for (std::size_t i = 0; i + 1 < part.states.size(); ++i, ++at) {
                samples_.push_back(sample_at(part.states[i], part.leg->motion, part.leg->stroke,
                                             signed_speed(speed[at], part.back)));
                t_ += 2 * (run.s[at + 1] - run.s[at]) / (speed[at] + speed[at + 1]);
            }
        }
        stood_ = run_.back().states.back();
        run_.clear();
    }

    const std::vector<Stroke>& strokes_;
    const Robot& robot_;
    const Options options_;
    std::vector<Part> run_;
    std::vector<Sample> samples_;
    std::optional<RobotState> stood_;
    double t_ = 0;
};

/// A drive that begins with a stroke waits until its pins are down; all others are told while it drives.
std::vector<Sample> waiting(std::vector<Sample> samples, const Robot& robot) {
    if (samples.empty()) return samples;
    const std::optional<Sample> stands = waiting_before(samples.front(), robot);
    if (!stands) return samples;
    for (Sample& sample : samples) sample.t += robot.lift_delay;
    samples.insert(samples.begin(), *stands);
    return samples;
}

}  // namespace

std::vector<Sample> timed(const std::vector<Leg>& legs, const std::vector<Stroke>& strokes,
                          const Robot& robot, const Options& options) {
    Timer timer(strokes, robot, options);
    for (const Leg& leg : legs) timer.add(leg);
    return waiting(timer.finished(), robot);
}

}  // namespace strandline::trajectory
