#include "result/tracking/tracking.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "math/nearest/nearest.hpp"
#include "result/tracking/reference.hpp"
#include "result/tracking/senses.hpp"

namespace strandline::tracking {
namespace {

/// The machine moves in steps that much finer than its commands.
constexpr int steps_a_tick = 4;
/// Metres behind its target at which the target begins to wait, and over which it comes to a stand.
constexpr double may_lag = 0.02, lag_range = 0.08;
/// The plan's own time is reached at the latest after so many times of it, or the robot is lost.
constexpr double most_times = 3, least_seconds = 30;
/// Damping of the steering: 1 comes back without swinging over.
constexpr double damping = 1.0;

/// The law of De Luca, Oriolo and Vendittelli, "Control of wheeled mobile robots: an experimental overview"
/// (RAMSETE, LNCIS 270, 2001), section 4.3, after Samson and Kanayama: the target's own speeds and the error
/// as the robot sees it. Linearised it has the poles of s^2 + 2 z a s + a^2, a^2 = w^2 + v^2 / l^2: along a
/// straight way a spring of natural length l, the look-ahead.
struct Command {
    double speed, turn_rate;
};
Command commanded(const Target& ahead, Pose believed, Pose target, double look_ahead) {
    const Point off = target.at - believed.at, forward = unit(believed.heading);
    const double along = dot(off, forward), aside = cross(forward, off);
    const double turned = wrap_angle(target.heading - believed.heading);
    const double gain = 2 * damping * std::hypot(ahead.turn_rate, ahead.speed / look_ahead);
    const double sinc = std::abs(turned) < 1e-6 ? 1 : std::sin(turned) / turned;
    return {ahead.speed * std::cos(turned) + gain * along,
            ahead.turn_rate + ahead.speed * sinc * aside / (look_ahead * look_ahead) + gain * turned};
}

/// The machine: what it does follows what it is told over one tick, as far as its accelerations go.
struct Machine {
    Pose pose;
    double speed = 0, turn_rate = 0;
    void approach(const Command& told, const Robot& robot, double tick) {
        const auto within = [](double now, double wished, double most) {
            return std::clamp(wished, now - most, now + most);
        };
        const double fastest = std::max(robot.speed, robot.travel_speed);
        const double backwards = robot.can_back_up ? -fastest : 0;
        end_speed_ = within(speed, std::clamp(told.speed, backwards, fastest), robot.acceleration * tick);
        end_rate_ = within(turn_rate, std::clamp(told.turn_rate, -robot.turn_rate, robot.turn_rate),
                           robot.turn_acceleration * tick);
    }
    /// One of `steps_a_tick` steps, the k-th.
    void step(int k, double begin_speed, double begin_rate, double time) {
        const double share = (k + 0.5) / steps_a_tick, done = (k + 1.0) / steps_a_tick;
        pose = moved(pose, begin_speed + share * (end_speed_ - begin_speed),
                     begin_rate + share * (end_rate_ - begin_rate), time);
        speed = begin_speed + done * (end_speed_ - begin_speed);
        turn_rate = begin_rate + done * (end_rate_ - begin_rate);
    }

  private:
    double end_speed_ = 0, end_rate_ = 0;
};

/// Distances to the planned rake path of the stroke that is being drawn.
class RakePath {
  public:
    explicit RakePath(const std::vector<Sample>& plan) : plan_(plan) {}
    double off(Point rake, std::size_t sample) {
        if (!tree_ || sample < first_ || sample >= last_) {
            // From where the stroke's rake goes down to where it is lifted: round a corner it is up.
            const auto drawn = [&](std::size_t i) {
                return plan_[i].motion == Motion::draw && plan_[i].stroke == plan_[sample].stroke;
            };
            first_ = last_ = sample;
            while (first_ > 0 && drawn(first_ - 1)) --first_;
            while (last_ + 1 < plan_.size() && drawn(last_)) ++last_;
            Polyline line;
            for (std::size_t i = first_; i <= last_; ++i) line.push_back(plan_[i].rake);
            tree_.emplace(segments_of(line, false));
        }
        return tree_->distance(rake);
    }

  private:
    const std::vector<Sample>& plan_;
    std::optional<SegmentTree> tree_;
    std::size_t first_ = 0, last_ = 0;  ///< the samples whose rake path the tree holds
};

class Loop {
  public:
    Loop(const Robot& robot, const std::vector<Sample>& plan, const Options& options)
        : robot_(robot),
          options_(options),
          tick_(1 / options.rate),
          chance_(options.seed),
          reference_(robot, plan),
          rake_path_(plan),
          plan_(plan),
          late_(static_cast<std::size_t>(std::lround(options.localisation.delay * options.rate))),
          wander_x_(drift(options.localisation.wander)),
          wander_y_(drift(options.localisation.wander)),
          slip_speed_(drift(options.localisation.slip)),
          slip_rate_(drift(options.localisation.slip)),
          estimate_(plan.front().pose, options.trust, late_) {
        machine_.pose = plan.front().pose;
    }

    Driven drive(const Progress& progress) {
        constexpr std::size_t report_every = 1024;
        const double latest = most_times * reference_.end() + least_seconds;
        for (std::size_t k = 0; planned_t_ < reference_.end(); ++k) {
            if (k % report_every == 0) {
                if (progress.stopped()) break;
                progress.report("drive", planned_t_ / reference_.end());
            }
            if (t_ > latest) {
                driven_.lost = true;
                break;
            }
            tick();
        }
        add_sample(planned_sample());
        driven_.samples.back().mask = 0;
        driven_.time = t_;
        if (ticks_down_ > 0) {
            driven_.mean = sum_ / ticks_down_;
            driven_.rms = std::sqrt(squares_ / ticks_down_);
        }
        return std::move(driven_);
    }

  private:
    Drift drift(double size) { return {size, options_.localisation.wander_time, tick_, chance_}; }
    std::size_t planned_sample() const { return reference_.at(planned_t_).sample; }

    void tick() {
        sense();
        const Pose believed = estimate_.now();
        const Target target = reference_.at(planned_t_);
        const double sense = target.speed < 0 ? -1 : 1;
        const double behind = sense * dot(target.pose.at - believed.at, unit(target.pose.heading));
        const double pace = std::clamp(1 - (behind - may_lag) / lag_range, 0.0, 1.0);
        const double next_t = std::min(planned_t_ + pace * tick_, reference_.end());
        // The command is for the end of this tick: the target then, the error as it is believed now.
        const Target ahead = reference_.at(next_t);
        machine_.approach(commanded(ahead, believed, target.pose, options_.look_ahead), robot_, tick_);
        tell_pins();
        move_pins(t_);
        log(believed, target);
        const double speed = machine_.speed, rate = machine_.turn_rate;
        add_sample(target.sample);
        for (int k = 0; k < steps_a_tick; ++k) {
            const double later = k * tick_ / steps_a_tick;
            if (move_pins(t_ + later)) add_sample(target.sample, later);
            machine_.step(k, speed, rate, tick_ / steps_a_tick);
        }
        estimate_.roll((speed + machine_.speed) / 2 * (1 + slip_speed_.next(chance_)),
                       (rate + machine_.turn_rate) / 2 * (1 + slip_rate_.next(chance_)), tick_);
        t_ += tick_;
        planned_t_ = next_t;
    }

    /// The place where the robot was `late` ticks ago, as it is told it now.
    void sense() {
        places_.push_back(machine_.pose);
        if (places_.size() <= late_) return;
        Pose fix = places_.front();
        places_.pop_front();
        const Localisation& l = options_.localisation;
        fix.at = fix.at + Point{wander_x_.next(chance_) + l.noise * chance_.normal(),
                                wander_y_.next(chance_) + l.noise * chance_.normal()};
        fix.heading += l.heading_noise * chance_.normal();
        estimate_.fix(fix);
    }

    void tell_pins() {
        // To the nearest tick; told earlier by as long as they take.
        const double lead = options_.lead_pins ? robot_.lift_delay : 0;
        const unsigned wished = reference_.mask_at(planned_t_ + lead + tick_ / 2);
        if (wished != told_) pins_.push_back({t_ + robot_.lift_delay, wished});
        told_ = wished;
    }
    bool move_pins(double now) {
        const unsigned before = mask_;
        constexpr double same_instant = 1e-9;
        for (; !pins_.empty() && pins_.front().t <= now + same_instant; pins_.pop_front())
            mask_ = pins_.front().mask;
        return mask_ != before;
    }

    void add_sample(std::size_t planned, double later = 0) {
        const Sample& from = plan_[planned];
        Sample sample;
        sample.t = t_ + later;
        sample.pose = {machine_.pose.at, wrap_angle(machine_.pose.heading)};
        sample.speed = machine_.speed;
        sample.turn_rate = machine_.turn_rate;
        sample.curvature = machine_.speed != 0 ? machine_.turn_rate / machine_.speed : 0;
        sample.rake = rake_at(robot_, machine_.pose);
        sample.mask = mask_;
        sample.motion = from.motion;
        sample.stroke = from.stroke;
        driven_.samples.push_back(sample);
    }

    void log(Pose believed, const Target& target) {
        LogLine line{
            t_,    planned_t_, machine_.pose, believed, target.pose, machine_.speed, machine_.turn_rate, {},
            mask_, 0};
        line.rake = rake_at(robot_, machine_.pose);
        if (mask_ != 0 && plan_[target.sample].motion == Motion::draw) {
            line.off = rake_path_.off(line.rake, target.sample);
            sum_ += line.off;
            squares_ += line.off * line.off;
            driven_.most = std::max(driven_.most, line.off);
            ++ticks_down_;
        }
        driven_.log.push_back(line);
    }

    struct PinMove {
        double t;
        unsigned mask;
    };
    const Robot& robot_;
    const Options options_;
    double tick_;
    Chance chance_;
    Reference reference_;
    RakePath rake_path_;
    const std::vector<Sample>& plan_;
    std::size_t late_;
    Drift wander_x_, wander_y_, slip_speed_, slip_rate_;
    Estimate estimate_;
    Machine machine_;
    std::deque<Pose> places_;
    std::deque<PinMove> pins_;
    unsigned mask_ = 0, told_ = 0;
    double t_ = 0, planned_t_ = 0;
    double sum_ = 0, squares_ = 0, ticks_down_ = 0;
    Driven driven_;
};

}  // namespace

Driven driven(const Robot& robot, const std::vector<Sample>& plan, const Options& options,
              const Progress& progress) {
    if (plan.size() < 2) return {};
    return Loop(robot, plan, options).drive(progress);
}

}  // namespace strandline::tracking
