// A drive as waypoints with a servo for the rake. A DO command takes effect when the waypoint before it is
// reached (ardupilot.org, Mission Commands), so it stands behind the waypoint at which the rake moves.
#include "result/exports/mission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "machine/pins/pins.hpp"

namespace strandline::exports {
namespace {

constexpr double least_tolerance = 0.001;  // m: closer than a tenth of what coordinates can say
constexpr int halvings = 30;

double rounded(double degrees) { return std::round(degrees * 1e7) / 1e7; }

/// The drive, and the samples that must be waypoints: ends, where the rake moves or the robot turns back,
/// stops.
struct Drive {
    std::vector<Sample> samples;
    std::vector<Point> path;
    std::vector<std::size_t> marks;
    std::set<std::size_t> stops;
    bool backs_from(std::size_t i) const {
        return i + 1 < samples.size() && backs(samples[i], samples[i + 1]);
    }
};
Drive drive_of(const Plan& plan) {
    Drive drive{pins::told(plan.robot, plan.samples), {}, {}, {}};
    for (const Sample& sample : drive.samples) drive.path.push_back(sample.pose.at);
    std::set<std::size_t> marks{0, drive.samples.size() - 1};
    for (const Span& span : spans_of(drive.samples)) marks.insert(span.first);
    for (const std::size_t at : stop_samples(plan, drive.samples)) drive.stops.insert(at);
    marks.insert(drive.stops.begin(), drive.stops.end());
    for (std::size_t i = 1; i < drive.samples.size(); ++i)
        if (drive.backs_from(i) != drive.backs_from(i - 1)) marks.insert(i);
    drive.marks.assign(marks.begin(), marks.end());
    return drive;
}

bool straight_within(const Drive& drive, std::size_t from, std::size_t to, double tolerance) {
    for (std::size_t i = from + 1; i < to; ++i)
        if (distance_to_segment(drive.path[i], drive.path[from], drive.path[to]) > tolerance) return false;
    return true;
}

/// The samples that are left as waypoints: from each the farthest one that a straight line reaches within the
/// tolerance, found by doubling steps, then halving. A fifth fewer than halving at the farthest point
/// (Douglas and Peucker) leaves on curves. O(n log n).
std::vector<std::size_t> kept(const Drive& drive, double tolerance) {
    std::vector<std::size_t> list{0};
    for (const std::size_t mark : drive.marks)
        while (list.back() < mark) {
            const std::size_t from = list.back();
            std::size_t reached = from + 1, beyond = mark + 1;
            for (std::size_t step = 2; from + step < beyond; step *= 2)
                if (straight_within(drive, from, from + step, tolerance))
                    reached = from + step;
                else
                    beyond = from + step;
            while (beyond - reached > 1) {
                const std::size_t middle = reached + (beyond - reached) / 2;
                (straight_within(drive, from, middle, tolerance) ? reached : beyond) = middle;
            }
            list.push_back(reached);
        }
    return list;
}

struct Thinned {
    double tolerance;
    std::vector<std::size_t> waypoints;
};
/// With about the least tolerance between `low`, which leaves too many waypoints, and `high`, which does not.
template <class Fits>
Thinned halved(const Drive& drive, double low, double high, const Fits& fits) {
    Thinned best{high, kept(drive, high)};
    for (int k = 0; k < halvings && best.tolerance > 1.01 * low; ++k) {
        const double middle = std::sqrt(low * best.tolerance);
        auto fewer = kept(drive, middle);
        if (fits(fewer))
            best = {middle, std::move(fewer)};
        else
            low = middle;
    }
    return best;
}

/// What to do where `allowed` leaves `needed` items, more than the autopilot holds.
template <class Fits>
std::string remedy_beyond(const Drive& drive, double allowed, std::size_t needed, const Fits& fits) {
    const std::string split = "cut the plan by strandline split, or set mission.items";
    constexpr double most_tolerance = 100;  // m: what can be set
    if (!fits(kept(drive, most_tolerance)))
        return fmt::format("{} to {} if it holds them; no tolerance will do", split, needed);
    // Rounded up to a millimetre, where it fits as well.
    double enough = std::ceil(1000 * halved(drive, allowed, most_tolerance, fits).tolerance) / 1000;
    while (enough < most_tolerance && !fits(kept(drive, enough))) enough += 0.001;
    return fmt::format("{} to {} if it holds them, or mission.tolerance to {:.3f} m", split, needed, enough);
}

/// How far the samples lie from the straight lines between waypoints.
double deviation(const Drive& drive, const std::vector<std::size_t>& waypoints) {
    double most = 0;
    for (std::size_t k = 1; k < waypoints.size(); ++k)
        for (std::size_t i = waypoints[k - 1] + 1; i < waypoints[k]; ++i)
            most = std::max(most, distance_to_segment(drive.path[i], drive.path[waypoints[k - 1]],
                                                      drive.path[waypoints[k]]));
    return most;
}

class Builder {
  public:
    Builder(const Plan& plan, const Drive& drive, Site site) : plan_(plan), drive_(drive) {
        mission_.site = std::move(site);
    }
    Mission built(const std::vector<std::size_t>& waypoints) {
        mission_.home = place(waypoints.front());
        rake(false);
        for (const std::size_t i : waypoints) visit(i);
        if (down_) rake(false);
        if (back_) reverse(false);
        return std::move(mission_);
    }
    double farthest_rounded() const { return farthest_rounded_; }

  private:
    Geographic place(std::size_t i) {
        const Geographic exact = to_geographic(mission_.site, drive_.path[i]);
        const Geographic at{rounded(exact.latitude), rounded(exact.longitude)};
        farthest_rounded_ =
            std::max(farthest_rounded_, distance(to_canvas(mission_.site, at), drive_.path[i]));
        return at;
    }
    void rake(bool down) {
        const Options::Mission& o = plan_.options.mission;
        mission_.items.push_back(
            {Command::set_servo,
             {static_cast<double>(o.servo), static_cast<double>(down ? o.down : o.up), 0, 0},
             {}});
        const double speed = down ? plan_.robot.speed : plan_.robot.travel_speed;
        if (speed != speed_) {
            constexpr double ground_speed = 1, throttle_as_it_is = -1;
            mission_.items.push_back(
                {Command::change_speed, {ground_speed, speed, throttle_as_it_is, 0}, {}});
        }
        speed_ = speed;
        down_ = down;
    }
    void reverse(bool back) {
        mission_.items.push_back({Command::set_reverse, {back ? 1.0 : 0.0, 0, 0, 0}, {}});
        back_ = back;
    }
    void visit(std::size_t i) {
        const Geographic at = place(i);
        if (drive_.stops.contains(i))
            mission_.items.push_back({Command::loiter_unlimited, {}, at});
        else if (last_ != at)  // a turn on the spot, or nearer than coordinates can say
            mission_.items.push_back({Command::waypoint, {}, at});
        last_ = at;
        const bool down = i + 1 < drive_.samples.size() && drive_.samples[i].mask != 0;
        if (down != down_) rake(down);
        if (drive_.backs_from(i) != back_) reverse(!back_);
    }

    const Plan& plan_;
    const Drive& drive_;
    Mission mission_;
    std::optional<Geographic> last_;
    double speed_ = -1, farthest_rounded_ = 0;
    bool down_ = false, back_ = false;
};

/// One servo lifts all pins: what is raked with some of them only.
void warn_of_pins(const Plan& plan, Warnings& warnings) {
    double all = 0, some = 0;
    for (std::size_t i = 0; i + 1 < plan.samples.size(); ++i) {
        const unsigned mask = plan.samples[i].mask;
        if (mask == 0) continue;
        const double moved = distance(plan.samples[i].rake, plan.samples[i + 1].rake);
        all += moved;
        if (pins_down(mask) != plan.robot.pins) some += moved;
    }
    if (some > 0)
        warnings.push_back(
            {"mission", fmt::format("one servo lifts all {} pins, and {:.1f} of {:.1f} m are to be raked "
                                    "with some of them",
                                    plan.robot.pins, some, all)});
}

}  // namespace

Outcome<Mission> mission_of(const Plan& plan) {
    if (plan.samples.size() < 2) return fail("mission", "the plan has no drive", "plan a drawing first");
    const Options::Mission& limits = plan.options.mission;
    const Drive drive = drive_of(plan);
    Warnings warnings;
    const Site site = site_of(plan, warnings);
    // Home, and what is no waypoint: a servo and perhaps a speed at each move of the rake.
    const auto items_for = [&](const std::vector<std::size_t>& waypoints) {
        return Builder(plan, drive, site).built(waypoints).items.size() + 1;
    };
    const auto most = static_cast<std::size_t>(limits.items);
    const auto fits = [&](const std::vector<std::size_t>& waypoints) { return items_for(waypoints) <= most; };
    std::vector<std::size_t> waypoints = kept(drive, least_tolerance);
    if (!fits(waypoints)) {
        const double allowed = std::max(least_tolerance, limits.tolerance);
        waypoints = kept(drive, allowed);
        if (const std::size_t needed = items_for(waypoints); needed > most)
            return fail("mission",
                        fmt::format("{} items are needed to stay within {} m (mission.tolerance), and the "
                                    "autopilot holds {} (mission.items)",
                                    needed, limits.tolerance, most),
                        remedy_beyond(drive, allowed, needed, fits));
        waypoints = halved(drive, least_tolerance, allowed, fits).waypoints;
    }
    Builder builder(plan, drive, site);
    Mission mission = builder.built(waypoints);
    const double off = deviation(drive, waypoints);
    mission.warnings = std::move(warnings);
    mission.warnings.push_back(
        {"mission", fmt::format("{} items; waypoints leave the path by up to {:.1f} cm, and coordinates of "
                                "1e-7 degrees move them by up to {:.1f} cm",
                                mission.items.size() + 1, 100 * off, 100 * builder.farthest_rounded())});
    warn_of_pins(plan, mission.warnings);
    return mission;
}

}  // namespace strandline::exports
