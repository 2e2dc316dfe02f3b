// Can the machine do what the samples say? Each sample by itself, then each interval between two.
//
// Key: v speed, w turn rate, k curvature, h heading, ds arc length, dt time of an interval from sample a to
// sample b.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "result/check/enclosure.hpp"
#include "result/check/faults.hpp"

namespace strandline::check {
namespace {

// ---- tolerances: what sampling and rounding explain
// --------------------------------------------------------
/// Share of every limit.
constexpr double share = 1e-3;
/// Metres: positions may be rounded to a micrometre, each.
constexpr double rounding = 4e-6;
/// Metres: the robot stands.
constexpr double standing = 1e-5;
/// Metres between the stated rake and P - L e(h).
constexpr double offset_tolerance = 1e-4;
/// Metres between samples.
constexpr double longest_step = 0.05;
/// Radians between the heading's change and the curvature's integral: rake up (clothoids: the trapezoid rule
/// is exact), rake down (the follower's curvature is smooth, not linear).
constexpr double heading_up = 0.002, heading_down = 0.01;
/// ... and the share of |dk| ds that the trapezoid rule may be wrong by; where the robot stands at one end
/// its curvature may be from before or after a jump there, which is half of it.
constexpr double bend_share = 0.15, jump_share = 0.5;
/// Radians between chord and mean heading (besides dk ds / 12, covered by bend_share).
constexpr double chord_tolerance = 0.01;
/// Metres that a position may be ahead of what its speed explains before it is called a jump.
constexpr double jump = 0.01;
/// m/s, rad/s: differences of speeds between samples, over and above the limit times dt.
constexpr double speed_noise = 1e-3, rate_noise = 5e-3;
/// Share of acceleration limits: between samples the planner's speeds are chords of its curve.
constexpr double acceleration_share = 0.05;
/// 1/m: curvature's own rounding.
constexpr double curvature_noise = 1e-4;
/// Radians between footprints that are looked at while the robot turns on the spot.
constexpr double footprint_step = 0.1;

class Judge {
  public:
    Judge(const Plan& plan, Faults& faults, Report& report)
        : plan_(plan),
          robot_(plan.robot),
          faults_(faults),
          report_(report),
          field_(plan),
          turns_freely_(plan.robot.min_radius <= 0) {}

    void judge() {
        const std::size_t n = plan_.samples.size();
        for (std::size_t i = 0; i < n; ++i) {
            at_ = static_cast<int>(i);
            sample(plan_.samples[i], i > 0 ? &plan_.samples[i - 1] : nullptr, i + 1 == n);
            if (i + 1 < n) interval(plan_.samples[i], plan_.samples[i + 1]);
        }
        if (n > 0) report_.time = plan_.samples.back().t - plan_.samples.front().t;
        for (const PlannedConnection& c : plan_.connections) connection(c);
    }

  private:
    /// Largest curvature to the side of this one, rake up.
    double bound_of(double curvature) const { return 1 / least_radius(robot_, curvature); }
    static bool bounded(Motion motion) { return motion == Motion::connect || motion == Motion::loop; }

    void fault(Law law, double excess, const Sample& s, std::string what) {
        faults_.add(excess, {law, std::move(what), s.pose.at, at_, s.stroke, element_of(plan_, s)});
    }

    // ---- one sample
    // ----------------------------------------------------------------------------------------
    void sample(const Sample& s, const Sample* before, bool last) {
        const double off = distance(s.rake, rake_place(s.pose));
        if (off > offset_tolerance)
            fault(Law::offset, off, s,
                  fmt::format("the rake is {:.4f} m from where it trails the robot, allowed {:.4f} m", off,
                              offset_tolerance));
        inside_field(s, s.pose.heading);

        const bool down =
            (!last && s.motion == Motion::draw) || (before != nullptr && before->motion == Motion::draw);
        const double limit = down ? robot_.speed : robot_.travel_speed;
        const bool pushed = s.speed < 0 && (down || (s.mask != 0 && robot_.rake_offset > 0));
        if (s.speed < 0 && (pushed || !robot_.can_back_up))
            fault(Law::speed, -s.speed, s,
                  fmt::format("backs up at {:.3f} m/s, allowed {}", -s.speed,
                              pushed ? "none with the rake down" : "none: the robot cannot"));
        if (std::abs(s.speed) > limit * (1 + share))
            fault(Law::speed, std::abs(s.speed), s,
                  fmt::format("speed {:.3f} m/s, allowed {:.3f} m/s", std::abs(s.speed), limit));
        if (std::abs(s.turn_rate) > robot_.turn_rate * (1 + share))
            fault(Law::turn_rate, std::abs(s.turn_rate), s,
                  fmt::format("turn rate {:.3f} rad/s, allowed {:.3f} rad/s", std::abs(s.turn_rate),
                              robot_.turn_rate));
        const double turning = s.speed * s.curvature, mismatch = std::abs(s.turn_rate - turning);
        if (s.motion != Motion::pivot && mismatch > rate_noise + 0.01 * std::abs(turning))
            fault(Law::turn_rate, mismatch, s,
                  fmt::format("turn rate {:.3f} rad/s, but speed times curvature is {:.3f} rad/s",
                              s.turn_rate, turning));
        if (!last && bounded(s.motion)) {
            // Where the robot stands its curvature may still be that of the piece before.
            const bool others = s.speed == 0 && before != nullptr && !bounded(before->motion);
            if (!others) report_.max_curvature_up = std::max(report_.max_curvature_up, std::abs(s.curvature));
            const double bound = turns_freely_ ? 0 : bound_of(s.curvature);
            if (!others && !turns_freely_ && std::abs(s.curvature) > bound * (1 + share) + curvature_noise)
                fault(Law::curvature, std::abs(s.curvature), s,
                      fmt::format("curvature {:.3f} 1/m rake up, allowed {:.3f} 1/m", std::abs(s.curvature),
                                  bound));
        }
        pins(s, last);
    }

    Point rake_place(Pose pose) const {
        const Point ahead = unit(pose.heading);
        return pose.at - robot_.rake_offset * ahead + robot_.rake_side * left_normal(ahead);
    }

    void inside_field(const Sample& s, double heading) {
        if (const auto found = field_.trespass(s.pose.at, heading))
            fault(Law::field, found->metres, s, found->what);
    }

    void pins(const Sample& s, bool last) {
        const auto bits = [&](unsigned mask) {
            return fmt::format("{:0{}b}", mask, std::clamp(robot_.pins, 1, 32));
        };
        if (last && s.mask != 0) {
            fault(Law::pins, 1, s,
                  fmt::format("pins {} are down at the end of the drive, allowed none", bits(s.mask)));
            return;
        }
        if (last) return;
        if (s.motion != Motion::draw) {
            const unsigned between = robot_.lifts ? 0 : pin_mask(robot_, robot_.pins);
            if (s.mask != between)
                fault(Law::pins, 1, s,
                      fmt::format("pins {} are down while the robot drives between strokes ({}), allowed {}",
                                  bits(s.mask), name_of(s.motion),
                                  robot_.lifts ? "none" : "all: they cannot be lifted"));
            return;
        }
        if (s.stroke < 0 || s.stroke >= static_cast<int>(plan_.strokes.size()))
            return;  // drawn_right names it
        const Stroke& stroke = plan_.strokes[static_cast<std::size_t>(s.stroke)];
        const unsigned allowed = pin_mask(robot_, stroke.pins);
        // A fill may lift single pins over sand that is raked already or not its own.
        const bool right = stroke.fill ? (s.mask & ~allowed) == 0 : s.mask == allowed;
        if (!right)
            fault(Law::pins, 1, s,
                  fmt::format("pins {} are down, the stroke's are {}", bits(s.mask), bits(allowed)));
    }

    // ---- from a to b
    // ---------------------------------------------------------------------------------------
    void interval(const Sample& a, const Sample& b) {
        const double chord = distance(a.pose.at, b.pose.at),
                     turn = wrap_angle(b.pose.heading - a.pose.heading);
        // The arc that the chord belongs to: exact for a circle, and a clothoid differs by O(ds^5).
        const double half = std::min(std::abs(turn) / 2, pi / 2),
                     ds = half > 1e-6 ? chord * half / std::sin(half) : chord;
        const double dt = b.t - a.t;
        if (a.motion != Motion::draw) report_.up_driven += ds;
        if (a.motion == Motion::pivot)
            on_the_spot(a, b, chord, turn, dt);
        else if (ds <= standing)
            standing_still(a, turn);
        else
            driving(a, b, ds, turn, dt);
        if (!(dt > 0)) {
            fault(Law::time, 1, a,
                  fmt::format("the next sample is {:.6f} s later, allowed more than 0 s", dt));
            return;
        }
        rates(a, b, std::abs(turn), dt);
    }

    void on_the_spot(const Sample& a, const Sample& b, double chord, double turn, double dt) {
        if (!robot_.can_pivot && !turns_freely_)
            fault(Law::curvature, std::abs(turn), a,
                  fmt::format("turns on the spot by {:.3f} rad, allowed none: the robot cannot", turn));
        if (chord > standing)
            fault(Law::position, chord, a,
                  fmt::format("moves {:.4f} m while it turns on the spot, allowed 0 m", chord));
        const double said = (a.turn_rate + b.turn_rate) / 2 * dt;
        const double off = std::abs(wrap_angle(turn - said)),
                     allowed =
                         slack(b.turn_rate - a.turn_rate, robot_.turn_acceleration, dt) + chord_tolerance;
        if (off > allowed)
            fault(Law::heading, off, a,
                  fmt::format("turns by {:.3f} rad on the spot, its turn rate explains {:.3f} rad", turn,
                              said));
        for (double share_done = footprint_step; share_done < std::abs(turn); share_done += footprint_step)
            inside_field(a, a.pose.heading + std::copysign(share_done, turn));
    }

    void standing_still(const Sample& a, double turn) {
        if (std::abs(turn) > heading_up && !turns_freely_)
            fault(Law::heading, std::abs(turn), a,
                  fmt::format("the heading jumps by {:.3f} rad where the robot stands, allowed {:.3f} rad",
                              turn, heading_up));
    }

    void driving(const Sample& a, const Sample& b, double ds, double turn, double dt) {
        if (ds > longest_step + 1e-4)
            fault(Law::step, ds, a,
                  fmt::format("the next sample is {:.3f} m on, allowed {:.3f} m", ds, longest_step));
        const double sense = backs(a, b) ? -1 : 1;
        const double said = std::abs(a.speed + b.speed) / 2 * std::max(dt, 0.0);
        const double may =
            slack(b.speed - a.speed, robot_.acceleration, dt) + 1e-4 + 0.01 * std::min(ds, longest_step);
        if (ds - said > std::max(may, jump))
            fault(Law::position, ds - said, a,
                  fmt::format("the position jumps {:.4f} m, its speed explains {:.4f} m", ds, said));
        else if (std::abs(ds - said) > may)
            fault(Law::time, std::abs(ds - said), a,
                  fmt::format("drives {:.4f} m, its speed and time explain {:.4f} m", ds, said));

        const bool rest = a.speed == 0 || b.speed == 0, up = bounded(a.motion);
        const double dk = b.curvature - a.curvature;
        const double bend =
            (up ? slack(dk, robot_.sharpness * (1 + share), ds) : bend_share * std::abs(dk) * ds) +
            (rest ? jump_share * std::abs(dk) * ds : 0);
        const double direction = heading(sense * (b.pose.at - a.pose.at));
        // Fitted curves meet within a tenth of the drawing's tolerance (docs/curve.md), the robot's path with
        // them.
        const double seam = a.motion == Motion::draw ? plan_.options.drawing.tolerance / 10 : 0;
        const double spin = (rounding + seam) / ds;
        double aside = std::abs(wrap_angle(direction - a.pose.heading - turn / 2));
        if (turns_freely_ && rest) aside -= std::abs(turn) / 2;  // a corner at the standing end
        if (aside > chord_tolerance + bend + spin)
            fault(Law::position, aside, a,
                  fmt::format("moves {:.3f} rad aside of its heading, allowed {:.3f} rad", aside,
                              chord_tolerance + bend + spin));
        // A pivot's samples have no curvature, so its first one does not end this interval's.
        const double end_curvature = b.motion == Motion::pivot ? a.curvature : b.curvature;
        const double explained = sense * (a.curvature + end_curvature) / 2 * ds;
        double off = std::abs(wrap_angle(turn - explained)),
               allowed = (up ? heading_up : heading_down) + bend + spin;
        if (b.motion == Motion::pivot) allowed += jump_share * ds * bound_slope(a, ds);
        // How a drawn curve is bent where the robot stands to turn, no sample says; where it looks there the
        // chord has proved.
        if ((turns_freely_ && rest) || (!up && b.motion == Motion::pivot)) off = 0;
        if (off > allowed)
            fault(Law::heading, off, a,
                  fmt::format("the heading changes by {:.4f} rad, its curvature explains {:.4f} rad, allowed "
                              "apart {:.4f} rad",
                              turn, explained, allowed));
        if (up) rake_up(a, b, ds, sense * turn, std::abs(dk), spin);
    }
    /// How much the curvature can have changed by the pivot at the end of an interval.
    double bound_slope(const Sample& a, double ds) const {
        return std::max(std::abs(a.curvature), robot_.sharpness * ds);
    }

    /// `turn`: of the body, as seen driving forward.
    void rake_up(const Sample& a, const Sample& b, double ds, double turn, double dk, double spin) {
        if (turns_freely_) return;
        const double bound = bound_of(turn), turned = std::abs(turn);
        if (turned > ds * bound * (1 + share) + heading_up + spin)
            fault(Law::curvature, turned / ds, a,
                  fmt::format("turns {:.3f} rad in {:.4f} m rake up: {:.3f} 1/m, allowed {:.3f} 1/m", turned,
                              ds, turned / ds, bound));
        // At a stand the curvature may be that of the other side.
        const bool ends = b.motion == Motion::pivot || (b.speed == 0 && b.motion != a.motion);
        if (ends) return;
        report_.max_sharpness_up = std::max(report_.max_sharpness_up, (dk - 2e-6) / ds);
        if (dk > robot_.sharpness * ds * (1 + share) + curvature_noise)
            fault(
                Law::sharpness, dk / ds, a,
                fmt::format(
                    "curvature changes by {:.3f} 1/m in {:.4f} m rake up: {:.2f} 1/m^2, allowed {:.2f} 1/m^2",
                    dk, ds, dk / ds, robot_.sharpness));
    }

    /// How far apart distance (or angle) and the mean of the end speeds times dt can be when the speed
    /// between them changes at most by `limit`: up at the limit first, down at the limit after, (limit^2 dt^2
    /// - dv^2) / (4 limit).
    static double slack(double dv, double limit, double dt) {
        return limit > 0 && dt > 0 ? std::max(0.0, (limit * limit * dt * dt - dv * dv) / (4 * limit)) : 0;
    }

    void rates(const Sample& a, const Sample& b, double turn, double dt) {
        if (turn > robot_.turn_rate * dt * 1.01 + heading_up)
            fault(Law::turn_rate, turn / dt, a,
                  fmt::format("turns {:.3f} rad in {:.3f} s, allowed {:.3f} rad/s", turn, dt,
                              robot_.turn_rate));
        const double dv = std::abs(b.speed - a.speed), dw = std::abs(b.turn_rate - a.turn_rate);
        if (dv > robot_.acceleration * dt * (1 + acceleration_share) + speed_noise)
            fault(Law::acceleration, dv / dt, a,
                  fmt::format("speed changes by {:.3f} m/s in {:.3f} s: {:.3f} m/s^2, allowed {:.3f} m/s^2",
                              dv, dt, dv / dt, robot_.acceleration));
        if (dw > robot_.turn_acceleration * dt * (1 + acceleration_share) + rate_noise)
            fault(Law::acceleration, dw / dt, a,
                  fmt::format(
                      "turn rate changes by {:.3f} rad/s in {:.3f} s: {:.3f} rad/s^2, allowed {:.3f} rad/s^2",
                      dw, dt, dw / dt, robot_.turn_acceleration));
    }

    // ---- the connections' own curves
    // -----------------------------------------------------------------------
    void connection(const PlannedConnection& c) {
        if (turns_freely_ || c.curve.pieces.empty()) return;
        const auto name = [&](Law law, double found, double allowed, const char* what, const char* unit) {
            if (found <= allowed * (1 + share) + curvature_noise) return;
            faults_.add(found,
                        {law,
                         fmt::format("{} {:.3f} {} in the connection from stroke {} to {}, allowed {:.3f} {}",
                                     what, found, unit, c.from, c.to, allowed, unit),
                         c.curve.start.at, -1, c.to, -1});
        };
        for (const double side : {1.0, -1.0}) {
            double tightest = 0;
            for (const Clothoid& piece : c.curve.pieces)
                tightest = std::max({tightest, side * piece.curvature, side * piece.end_curvature()});
            name(Law::curvature, tightest, bound_of(side), "curvature", "1/m");
        }
        name(Law::sharpness, max_sharpness(c.curve), robot_.sharpness, "sharpness", "1/m^2");
    }

    const Plan& plan_;
    const Robot& robot_;
    Faults& faults_;
    Report& report_;
    Enclosure field_;
    bool turns_freely_;
    int at_ = 0;
};

}  // namespace

void check_motion(const Plan& plan, Faults& faults, Report& report) { Judge(plan, faults, report).judge(); }

}  // namespace strandline::check
