#pragma once
// Small valid plans, driven by hand: no planning room has a part in them. Each curve begins where the one
// before ended, so elements are defined by where the robot has come.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "plan/model/model.hpp"

namespace strandline::by_hand {

/// Lays curves end to end and times them: forward and backward over v^2, at rest at the ends and at turns on
/// the spot.
class Drive {
  public:
    explicit Drive(Robot robot, Pose start) : at_(start) { plan_.robot = std::move(robot); }

    Pose at() const { return at_; }
    Point rake() const { return at_.at - plan_.robot.rake_offset * unit(at_.heading); }
    Plan& plan() { return plan_; }

    Drive& go(std::vector<Clothoid> pieces, Motion motion = Motion::connect, int stroke = -1) {
        const Curve curve{at_, std::move(pieces)};
        if (motion == Motion::connect)
            connection_ = joined(connection_.pieces.empty() ? Curve{at_, {}} : connection_, curve);
        for (const CurvePoint& p : sampled(curve, step)) {
            if (!go_.empty() && p.s == 0) {
                go_.back().motion = motion;
                go_.back().stroke = stroke;
                continue;
            }
            go_.push_back({(go_.empty() ? 0 : go_.back().s) + p.s - (p.s > 0 ? last_s_ : 0), p.pose,
                           p.curvature, motion, stroke});
            last_s_ = p.s;
        }
        last_s_ = 0;
        at_ = end_pose(curve);
        return *this;
    }
    Drive& ahead(double metres) { return go({{metres, 0, 0}}); }
    /// A continuous-curvature turn a little inside the robot's limits.
    Drive& turn(double angle) { return go(turning(angle)); }
    std::vector<Clothoid> turning(double angle) const {
        const double sigma = 0.98 * plan_.robot.sharpness;
        const double k = std::min(0.98 / plan_.robot.min_radius, std::sqrt(std::abs(angle) * sigma));
        const double side = angle < 0 ? -1 : 1, ramp = k / sigma,
                     arc = std::max(0.0, (std::abs(angle) - k * k / sigma) / k);
        return {{ramp, 0, side * sigma}, {arc, side * k, 0}, {ramp, side * k, -side * sigma}};
    }
    /// Round and back, `aside` to the left (side 1) or right (-1) of where it came from.
    Drive& round_back(double aside, double side) {
        double low = 0, high = pi / 2;
        const auto pieces = [&](double alpha) {
            std::vector<Clothoid> all = turning(-side * alpha);
            for (double angle : {side * (pi + 2 * alpha), -side * alpha})
                for (const Clothoid& piece : turning(angle)) all.push_back(piece);
            return all;
        };
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (side * end_pose({{}, pieces(middle)}).at.y > aside ? low : high) = middle;
        }
        return go(pieces(low));
    }
    Drive& turn_on_the_spot(double angle) {
        rest();
        constexpr int parts = 40;
        const Robot& robot = plan_.robot;
        const double part = std::abs(angle) / parts;
        const auto rate = [&](int i) {
            return std::min(robot.turn_rate,
                            std::sqrt(2 * robot.turn_acceleration * part * std::min(i, parts - i)));
        };
        for (int i = 0; i < parts; ++i) {
            Sample s = sample({0, at_, 0, Motion::pivot, -1}, 0);
            s.pose.heading = wrap_angle(at_.heading + angle * i / parts);
            s.rake = s.pose.at - robot.rake_offset * unit(s.pose.heading);
            s.turn_rate = std::copysign(rate(i), angle);
            plan_.samples.push_back(s);
            t_ += 2 * part / (rate(i) + rate(i + 1));
        }
        at_.heading += angle;
        return *this;
    }

    int element(Element element) {
        plan_.drawing.elements.push_back(std::move(element));
        return static_cast<int>(plan_.drawing.elements.size()) - 1;
    }
    /// Draws the curve with the robot; `rake_path` is what the rake is to leave.
    Drive& draw(int element, int pins, Curve rake_path, std::vector<Clothoid> robot_path, bool fill = false) {
        const int number = begin_stroke(element, pins, fill);
        plan_.strokes.back().rake_path = {std::move(rake_path)};
        return go(std::move(robot_path), Motion::draw, number);
    }
    Drive& draw_ahead(int element, int pins, double metres, bool fill = false) {
        return draw(element, pins, straight({rake(), at_.heading}, metres), {{metres, 0, 0}}, fill);
    }
    int begin_stroke(int element, int pins, bool fill = false) {
        const int number = static_cast<int>(plan_.strokes.size());
        if (number > 0) plan_.connections.push_back({number - 1, number, 0, 0, connection_});
        connection_ = {};
        Stroke stroke;
        stroke.element = element;
        stroke.pins = pins;
        stroke.fill = fill;
        plan_.strokes.push_back(stroke);
        plan_.order.push_back({number, 0, false});
        return number;
    }

    Plan finished() {
        rest();
        plan_.samples.push_back(sample({0, at_, 0, Motion::connect, -1}, 0));
        return plan_;
    }

    static constexpr double step = 0.02;

  private:
    struct State {
        double s;
        Pose pose;
        double curvature;
        Motion motion;
        int stroke;
    };

    Sample sample(const State& state, double speed) const {
        Sample s;
        s.t = t_;
        s.pose = {state.pose.at, wrap_angle(state.pose.heading)};
        s.curvature = state.curvature;
        s.speed = speed;
        s.turn_rate = speed * state.curvature;
        s.rake = s.pose.at - plan_.robot.rake_offset * unit(s.pose.heading);
        s.motion = state.motion;
        s.stroke = state.stroke;
        if (s.motion == Motion::draw)
            s.mask = pin_mask(plan_.robot, plan_.strokes[static_cast<std::size_t>(s.stroke)].pins);
        return s;
    }
    void rest() {
        if (go_.size() < 2) return;
        const Robot& robot = plan_.robot;
        std::vector<double> u(go_.size(), 0);
        for (std::size_t i = 1; i + 1 < u.size(); ++i) {
            const double ds = go_[i].s - go_[i - 1].s;
            // The slower of both sides' limits; k' v^2 + k a stays below the turn acceleration of the robots
            // used here.
            const bool down = go_[i].motion == Motion::draw || go_[i - 1].motion == Motion::draw;
            const double v = std::min(down ? robot.speed : robot.travel_speed,
                                      0.95 * robot.turn_rate / std::max(1e-9, std::abs(go_[i].curvature)));
            u[i] = std::min(v * v, u[i - 1] + 2 * 0.98 * robot.acceleration * ds);
        }
        for (std::size_t i = u.size() - 1; i-- > 0;)
            u[i] = std::min(u[i], u[i + 1] + 2 * 0.98 * robot.acceleration * (go_[i + 1].s - go_[i].s));
        for (std::size_t i = 0; i + 1 < u.size(); ++i) {
            plan_.samples.push_back(sample(go_[i], std::sqrt(u[i])));
            t_ += 2 * (go_[i + 1].s - go_[i].s) / (std::sqrt(u[i]) + std::sqrt(u[i + 1]));
        }
        go_.clear();
    }

    Plan plan_;
    Pose at_;
    Curve connection_;
    std::vector<State> go_;
    double last_s_ = 0, t_ = 0;
};

inline Robot raking_robot() {
    Robot robot;
    robot.turn_rate = 0.5;
    robot.turn_acceleration = 1.0;
    robot.wheels = {{{0, 0.1}, 0.05}, {{0, -0.1}, 0.05}};
    return robot;
}

inline Element line_element(std::string id, Path path, int pins) {
    return {std::move(id), "", LineElement{std::move(path), pins}, -1};
}

/// A straight line with 3 pins, an arc with 1, and a turned rectangle filled by three strokes.
inline Plan raked_plan() {
    Drive drive(raking_robot(), {{6, 4}, 0.3});
    drive.plan().title = "by hand";
    const Point from = drive.rake();
    const int line =
        drive.element(line_element("line", path_through({from, from + 2.0 * unit(0.3)}, false), 3));
    drive.draw_ahead(line, 3, 2.0);
    drive.turn(1.4).ahead(0.5).turn(1.4);

    // The rake 0.2 m behind goes round the same centre on a radius of 1 m.
    constexpr double rake_radius = 1.0, sweep = 1.2;
    const double radius = std::sqrt(rake_radius * rake_radius - 0.04), k = 1 / radius, sigma = 9.0;
    drive.go({{k / sigma, 0, sigma}});
    const Point centre = drive.at().at + radius * left_normal(unit(drive.at().heading));
    const double start = heading(drive.rake() - centre);
    const int arc = drive.element(line_element("arc",
                                               {drive.rake(),
                                                {ArcSegment{centre,
                                                            {rake_radius, 0},
                                                            {0, rake_radius},
                                                            start,
                                                            sweep,
                                                            centre + rake_radius * unit(start + sweep)}},
                                                false},
                                               1));
    drive.draw(arc, 1, {{drive.rake(), start + pi / 2}, {{sweep * rake_radius, 1 / rake_radius, 0}}},
               {{sweep * radius, k, 0}});
    drive.go({{k / sigma, k, -sigma}}).ahead(1.0).turn(-1.6).ahead(1.4);

    constexpr double swath = 0.42, edge = 1.6;
    const Point along = unit(drive.at().heading), left = left_normal(along),
                corner = drive.rake() - swath / 2 * left;
    const int region =
        drive.element({"area", "",
                       RegionElement{{{corner, corner + edge * along,
                                       corner + edge * along + 3 * swath * left, corner + 3 * swath * left},
                                      {}}},
                       -1});
    for (int i = 0; i < 3; ++i) {
        if (i > 0) drive.round_back(swath, i % 2 == 1 ? 1 : -1).ahead(0.4);
        drive.draw_ahead(region, 7, edge, true);
    }
    return drive.ahead(0.3).finished();
}

}  // namespace strandline::by_hand
