#include "result/sand/sand.hpp"

#include <algorithm>
#include <cmath>

#include "machine/pins/pins.hpp"
#include "result/sand/accounts.hpp"
#include "result/sand/crossings.hpp"

namespace strandline::sand {
namespace {

/// Metres: a longer step between samples is a jump of a broken plan, not a drive.
constexpr double longest_step = 1.0;
/// Metres round the field that are still laid; farther out the plan is broken, and the raster would only
/// grow.
constexpr double outside_field = 5.0;
/// Metres round the ends of a rake-up move where it may cross lines: it leaves one and reaches another there.
constexpr double own_end = 0.05;
/// Metres: crossings that near are one point, seen from two pieces.
constexpr double same_point = 1e-6;
/// Samples between reports of progress.
constexpr std::size_t report_every = 2048;

/// The robot's axes at a sample, in the field's frame.
struct Axes {
    Point at, forward, left;
};
Axes axes_of(Pose pose) {
    const Point forward = unit(pose.heading);
    return {pose.at, forward, left_normal(forward)};
}
Point in_field(const Axes& axes, Point body) { return axes.at + body.x * axes.forward + body.y * axes.left; }

/// Gathers what happens to finished ground, events that follow closely as one.
class Events {
  public:
    explicit Events(double gap) : gap_(gap) {}
    void add(int element, Point at, double t, double driven, double area, int crossings) {
        // Few elements are under the robot at a time: look back over the latest events only.
        for (std::size_t k = open_.size(); k-- > 0;) {
            Open& open = open_[k];
            if (blemishes_[open.blemish].element != element) continue;
            blemishes_[open.blemish].area += area;
            blemishes_[open.blemish].crossings += crossings;
            open.driven = driven;
            return;
        }
        open_.push_back({blemishes_.size(), driven});
        blemishes_.push_back({.at = at, .area = area, .crossings = crossings, .element = element, .t = t});
    }
    void close_before(double driven) {
        std::erase_if(open_, [&](const Open& open) { return driven - open.driven > gap_; });
    }
    std::vector<Blemish> take() { return std::move(blemishes_); }

  private:
    struct Open {
        std::size_t blemish;
        double driven;
    };
    double gap_;
    std::vector<Open> open_;
    std::vector<Blemish> blemishes_;
};

/// Goes through the samples once, laying each interval's wheels and rake.
class Layer {
  public:
    Layer(const Plan& plan, const Options& options)
        : plan_(plan),
          options_(options),
          ground_(options.cell),
          field_(grown(field_of(plan), outside_field)),
          laid_(laid_box()),
          owners_(region_owners(plan, options.cell, laid_)),
          events_(options.pass_gap) {}

    Sand lay(const Progress& progress) {
        const std::vector<Sample>& samples = plan_.samples;
        for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
            if (i % report_every == 0) {
                if (progress.stopped()) break;
                progress.report("sand", static_cast<double>(i) / static_cast<double>(samples.size()));
            }
            const Sample &a = samples[i], &b = samples[i + 1];
            const bool up = a.motion != Motion::draw;
            if (up && (i == 0 || samples[i - 1].motion == Motion::draw)) move_end_ = end_of_move(i);
            if (up && (i == 0 || samples[i - 1].motion == Motion::draw)) move_begin_ = i;
            const double step = distance(a.pose.at, b.pose.at);
            if (contains(field_, a.pose.at) && contains(field_, b.pose.at) && step <= longest_step) {
                events_.close_before(driven_);
                roll(a, b);
                if (up) cross(a, b);
                rake(a, b);
            }
            driven_ += step;
        }
        Sand sand{.ground = std::move(ground_),
                  .regions = {},
                  .bare = {},
                  .spill = 0,
                  .driven = driven_,
                  .blemishes = events_.take()};
        Accounts accounts = region_accounts(plan_, sand.ground, laid_);
        sand.regions = std::move(accounts.regions);
        sand.bare = std::move(accounts.bare);
        sand.spill = spilt_ * options_.cell * options_.cell;
        return sand;
    }

  private:
    /// Where rake or wheels can have touched the ground.
    Box laid_box() const {
        Box box;
        for (const Sample& sample : plan_.samples)
            if (contains(field_, sample.pose.at)) box = including(box, sample.pose.at);
        double reach = plan_.robot.rake_offset + std::abs(plan_.robot.rake_side) + plan_.robot.rake_width();
        for (const Wheel& wheel : plan_.robot.wheels) reach = std::max(reach, length(wheel.at) + wheel.width);
        return box.empty() ? box : grown(box, reach);
    }
    int element_of(const Sample& sample) const {
        const bool known = sample.stroke >= 0 && sample.stroke < static_cast<int>(plan_.strokes.size());
        return known ? plan_.strokes[static_cast<std::size_t>(sample.stroke)].element : -1;
    }
    bool is_line(int element) const {
        return element >= 0 && element < static_cast<int>(plan_.drawing.elements.size()) &&
               std::holds_alternative<LineElement>(
                   plan_.drawing.elements[static_cast<std::size_t>(element)].what);
    }
    std::size_t end_of_move(std::size_t i) const {
        while (i + 1 < plan_.samples.size() && plan_.samples[i].motion != Motion::draw) ++i;
        return i;
    }

    void roll(const Sample& a, const Sample& b) {
        const int drawing = a.motion == Motion::draw ? element_of(a) : -1;
        const float now = static_cast<float>(driven_);
        const Axes from = axes_of(a.pose), to = axes_of(b.pose);
        for (const Wheel& wheel : plan_.robot.wheels) {
            const double left = wheel.at.y + wheel.width / 2, right = wheel.at.y - wheel.width / 2;
            const Bar track =
                swept_bar(in_field(from, {wheel.at.x, left}), in_field(from, {wheel.at.x, right}),
                          in_field(to, {wheel.at.x, left}), in_field(to, {wheel.at.x, right}));
            for_cells_in(ground_, track.outline(), [&](int i, int j) {
                Cell& cell = ground_.at(i, j);
                const bool new_pass = cell.last_rolled == Cell::never ||
                                      now - cell.last_rolled > options_.pass_gap ||
                                      cell.last_rolled < cell.last_raked;
                const bool settled = cell.passes > 0 && now - cell.last_raked >= options_.settled;
                cell.last_rolled = now;
                if (!new_pass || !settled) return;
                const int owner = owners_.at(i, j);
                if (owner >= 0 && owner != drawing)
                    events_.add(owner, ground_.centre(i, j), a.t, driven_, options_.cell * options_.cell, 0);
            });
        }
    }

    void cross(const Sample& a, const Sample& b) {
        const Sample &begin = plan_.samples[move_begin_], &end = plan_.samples[move_end_];
        for (const LineCrossing& hit : lines_.crossed(a.pose.at, b.pose.at)) {
            bool excused = false;
            for (Point own : {begin.pose.at, begin.rake, end.pose.at, end.rake})
                excused |= distance(hit.at, own) <= own_end;
            if (excused || (hit.element == last_hit_.element && distance(hit.at, last_hit_.at) < same_point))
                continue;
            last_hit_ = hit;
            events_.add(hit.element, hit.at, a.t, driven_, 0, 1);
        }
    }

    void rake(const Sample& a, const Sample& b) {
        if (a.mask == 0) return;
        const int element = element_of(a);
        const bool line = is_line(element);
        if (line && a.rake != b.rake)
            lines_.add({drawn_at(plan_.robot, a, a.mask), drawn_at(plan_.robot, b, a.mask), element});
        const float now = static_cast<float>(driven_);
        const Point left0 = left_normal(unit(a.pose.heading)), left1 = left_normal(unit(b.pose.heading));
        for (const pins::Comb& comb : pins::combs_of(plan_.robot, a.mask)) {
            const Bar swath = swept_bar(a.rake + comb.left * left0, a.rake + comb.right * left0,
                                        b.rake + comb.left * left1, b.rake + comb.right * left1);
            for_cells_in(ground_, swath.outline(), [&](int i, int j) {
                Cell& cell = ground_.at(i, j);
                if (cell.passes == 0) {
                    cell.first_raked = now;
                    cell.passes = 1;
                    if (!line && owners_.at(i, j) < 0) ++spilt_;
                } else if (now - cell.last_raked > options_.pass_gap) {
                    ++cell.passes;
                }
                cell.last_raked = now;
                cell.element = static_cast<std::int32_t>(element);
            });
        }
    }

    const Plan& plan_;
    const Options& options_;
    Ground ground_;
    Box field_, laid_;
    Owners owners_;
    Events events_;
    DrawnLines lines_;
    LineCrossing last_hit_;
    std::size_t move_begin_ = 0, move_end_ = 0;
    double driven_ = 0;
    std::size_t spilt_ = 0;
};

}  // namespace

Sand simulate(const Plan& plan, const Options& options, const Progress& progress) {
    return Layer(plan, options).lay(progress);
}

}  // namespace strandline::sand
