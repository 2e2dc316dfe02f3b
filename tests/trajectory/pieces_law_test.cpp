// Whatever is driven, replaced and asked for again: pieces are the drive timed in whole.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "path/trajectory/trajectory.hpp"

namespace strandline::trajectory {
namespace {

/// What differs first, at a time and a speed within rounding.
std::string difference(const std::vector<Sample>& pieces, const std::vector<Sample>& whole) {
    constexpr double rounding = 1e-6;
    if (pieces.size() != whole.size())
        return std::to_string(pieces.size()) + " samples instead of " + std::to_string(whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        Sample sample = pieces[i];
        const Sample& wanted = whole[i];
        if (std::abs(sample.t - wanted.t) > rounding || std::abs(sample.speed - wanted.speed) > rounding ||
            std::abs(sample.turn_rate - wanted.turn_rate) > rounding)
            return "time or speed of sample " + std::to_string(i) + " of " + std::to_string(whole.size());
        sample.t = wanted.t;
        sample.speed = wanted.speed;
        sample.turn_rate = wanted.turn_rate;
        if (!(sample == wanted)) return "sample " + std::to_string(i) + " of " + std::to_string(whole.size());
    }
    return "";
}

/// Random drives from the origin, each stretch from where the one before ended.
class Drive {
  public:
    explicit Drive(unsigned seed) : random_(seed) {
        for (int k = below(8) + 2; k > 0; --k) stretches_.push_back(stretch_from(end_));
        number_strokes();
    }

    /// One stretch is another, over the same ground: those behind it stay the same objects.
    void replace_one() {
        const std::size_t k = at_random();
        std::vector<Leg> legs = *stretches_[k].legs;
        for (Leg& leg : legs) {
            if (leg.motion == Motion::pivot) continue;
            leg.motion = below(2) ? Motion::draw : Motion::connect;
            leg.stroke = leg.motion == Motion::draw ? 0 : -1;
        }
        stretches_[k].legs = std::make_shared<const std::vector<Leg>>(std::move(legs));
        number_strokes();
    }
    /// All from there on are others.
    void drive_on_otherwise() {
        const std::size_t k = at_random();
        end_ = stretches_[k].legs->front().path.front().pose;
        stretches_.resize(k);
        for (int more = below(4) + 1; more > 0; --more) stretches_.push_back(stretch_from(end_));
        number_strokes();
    }
    /// Round in a ring, which is one object, as often as that.
    void end_in_rings(int rounds) {
        const Stretch ring = curved(end_, Motion::draw, 0.5, 4 * pi);
        stretches_.insert(stretches_.end(), static_cast<std::size_t>(rounds), ring);
        number_strokes();
    }
    void change_pins() {
        for (Stroke& stroke : strokes_) stroke.pins = 1 + below(7);
    }
    int below(int n) { return std::uniform_int_distribution(0, n - 1)(random_); }
    const std::vector<Stretch>& stretches() const { return stretches_; }
    const std::vector<Stroke>& strokes() const { return strokes_; }

  private:
    std::size_t at_random() { return static_cast<std::size_t>(below(static_cast<int>(stretches_.size()))); }

    static Leg leg_of(const Curve& curve, Motion motion) {
        return {motion, motion == Motion::draw ? 0 : -1, states_along(curve, 0.05), {}};
    }
    Stretch curved(Pose from, Motion motion, double curvature, double metres) {
        return {std::make_shared<const std::vector<Leg>>(
                    std::vector<Leg>{leg_of({from, {{curvature, metres, 0}}}, motion)}),
                0};
    }
    /// One leg, or three with a bend within, or a turn on the spot.
    Stretch stretch_from(Pose& from) {
        const Motion motion = below(2) ? Motion::draw : Motion::connect;
        const double metres = 0.1 + 0.5 * below(8), curvature = 0.4 * (below(4) - 2);
        std::vector<Leg> legs;
        const auto drive = [&](const Curve& curve, Motion how) {
            legs.push_back(leg_of(curve, how));
            from = end_pose(curve);
        };
        switch (below(4)) {
            case 0:
                legs.push_back(
                    {Motion::pivot, -1, {{0, from, 0}, {0, {from.at, from.heading + curvature}, 0}}, {}});
                from.heading += curvature;
                break;
            case 1:
                drive({from, {{0, metres, 0}}}, motion);
                drive({from, {{curvature, metres, 0}}}, Motion::loop);
                drive({from, {{0, metres, 0}}}, motion);
                break;
            case 2:  // into a bend and out of it, without a jump
                drive({from, {{0, metres, curvature / metres}, {curvature, metres, -curvature / metres}}},
                      motion);
                break;
            default:
                drive({from, {{curvature, metres, 0}}}, motion);
        }
        return {std::make_shared<const std::vector<Leg>>(std::move(legs)), 0};
    }
    void number_strokes() {
        int next = 0;
        for (Stretch& stretch : stretches_) {
            stretch.stroke = next;
            for (const Leg& leg : *stretch.legs)
                if (leg.motion == Motion::draw) next = stretch.stroke + 1;
        }
        strokes_.resize(static_cast<std::size_t>(next));
    }

    std::mt19937 random_;
    Pose end_{{0, 0}, 0};
    std::vector<Stretch> stretches_;
    std::vector<Stroke> strokes_;
};

TEST(Pieces, AreTheDriveTimedInWholeWhateverChangedBetweenTwoCalls) {
    std::vector<Robot> robots{*builtin_robot("beachbot"), *builtin_robot("turf"), *builtin_robot("plotter")};
    for (Robot& robot : robots) robot.lift_delay = 0.4;
    robots.push_back(robots.front());
    robots.back().lift_delay = 0;
    robots.back().acceleration /= 2;
    int waits = 0, again = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        Drive drive(seed);
        Pieces pieces;
        Options options;
        std::size_t robot = 0;
        std::string what = "made";
        for (int call = 0; call < 12; ++call) {
            const auto placed = pieces.timed(drive.stretches(), drive.strokes(), robots[robot], options);
            const auto whole = timed(legs_of(drive.stretches()), drive.strokes(), robots[robot], options);
            const std::string differs = difference(joined(placed), whole);
            ASSERT_EQ(differs, "") << "seed " << seed << ", call " << call << ", " << what;
            if (what == "asked again") {
                ++again;
                waits += robots[robot].lift_delay > 0 && whole.size() > 1 && whole[1].mask != 0;
            }
            switch (drive.below(7)) {
                case 0:
                    what = "asked again";
                    break;
                case 1:
                    what = "other pins";
                    drive.change_pins();
                    break;
                case 2:
                    what = "another robot";
                    robot = static_cast<std::size_t>(drive.below(static_cast<int>(robots.size())));
                    break;
                case 3:
                    what = "other options";
                    options = {.step = 0.02 * (1 + drive.below(3)), .dwell = 0.1 * drive.below(3)};
                    break;
                case 4:
                    what = "driven on otherwise";
                    drive.drive_on_otherwise();
                    break;
                case 5:
                    what = "a ring";
                    drive.end_in_rings(1 + drive.below(3));
                    break;
                default:
                    what = "one replaced";
                    drive.replace_one();
            }
        }
    }
    EXPECT_GT(again, 50);
    EXPECT_GT(waits, 10) << "drives that begin with a stroke, and wait for the pins";
}

}  // namespace
}  // namespace strandline::trajectory
