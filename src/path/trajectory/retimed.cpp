// A drive whose ends have moved, timed anew.
#include <cmath>

#include "path/trajectory/speeds.hpp"
#include "path/trajectory/timer.hpp"
#include "path/trajectory/trajectory.hpp"

namespace strandline::trajectory {
namespace {

/// Length of the circular arc between two poses: the chord, made longer by the turn.
double arc_between(Pose a, Pose b) {
    const double half = wrap_angle(b.heading - a.heading) / 2, chord = distance(a.at, b.at);
    return std::abs(half) < 1e-6 ? chord : chord * half / std::sin(half);
}

/// Metres: nearer than this the robot stands; samples of one stand differ by rounding.
constexpr double same_place = 1e-9;
bool stands(const Sample& a, const Sample& b) { return distance(a.pose.at, b.pose.at) < same_place; }

}  // namespace

std::vector<Sample> retimed(std::vector<Sample> samples, const Robot& robot) {
    if (samples.empty()) return samples;
    double t = 0, was = samples.front().t;
    for (std::size_t first = 0; first + 1 < samples.size();) {
        const double wait = samples[first + 1].t - was;
        was = samples[first + 1].t;
        samples[first].t = t;
        // Standing, or turning on the spot: it takes as long as it took.
        if (stands(samples[first], samples[first + 1])) {
            t += wait;
            ++first;
            continue;
        }
        Course run;
        run.s.push_back(0);
        run.curvature.push_back(samples[first].curvature);
        std::size_t last = first;
        do {
            const Sample &a = samples[last], &b = samples[last + 1];
            run.s.push_back(run.s.back() + arc_between(a.pose, b.pose));
            run.limit.push_back(a.motion == Motion::draw ? robot.speed : robot.travel_speed);
            run.curvature.push_back(b.curvature);
            ++last;
        } while (last + 1 < samples.size() && samples[last].speed != 0 &&
                 !stands(samples[last], samples[last + 1]));
        was = samples[last].t;
        const std::vector<double> speed = speeds_along(run, robot);
        const bool back = backs(samples[first], samples[first + 1]);
        for (std::size_t k = 0; k + 1 < speed.size(); ++k) {
            Sample& sample = samples[first + k];
            sample.t = t;
            sample.speed = signed_speed(speed[k], back);
            sample.turn_rate = sample.speed * sample.curvature;
            t += 2 * (run.s[k + 1] - run.s[k]) / (speed[k] + speed[k + 1]);
        }
        first = last;
    }
    Sample& end = samples.back();
    end.t = t;
    end.speed = end.turn_rate = 0;
    return samples;
}

}  // namespace strandline::trajectory
