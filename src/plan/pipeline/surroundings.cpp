#include "plan/pipeline/surroundings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "math/region/region.hpp"

namespace strandline::pipeline {
namespace {

Polygon corners_of(Box box) { return {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}; }

/// Looking away from the drawing, on all four sides of it, with the robot wholly outside.
std::vector<Pose> exits_of(const Drawing& drawing, double reach) {
    Box box;
    for (const Element& element : drawing.elements) box = united(box, bounds(element));
    box = grown(box, 2 * reach);
    std::vector<Pose> exits;
    constexpr int by_side = 5;
    const Polygon corners = corners_of(box);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point a = corners[i], b = corners[(i + 1) % corners.size()];
        for (int k = 0; k < by_side; ++k)
            exits.push_back({between(a, b, (k + 0.5) / by_side), heading(-left_normal(b - a))});
    }
    return exits;
}

/// Those at which the footprint may stand.
std::vector<Pose> allowed(const std::vector<Pose>& exits, const DriveArea& area, const Robot& robot) {
    std::vector<Pose> fit;
    for (const Pose& exit : exits)
        if (strandline::stays_within(robot, exit.at, exit.heading, area.border) &&
            std::ranges::all_of(area.keep_out, [&](const Region& keep_out) {
                return keeps_off(robot, exit.at, exit.heading, keep_out);
            }))
            fit.push_back(exit);
    return fit.empty() ? exits : fit;
}

/// Where the footprint may be.
class Standing {
  public:
    Standing(const DriveArea& area, const Robot& robot) : area_(area), robot_(robot) {
        for (const Region& region : area.keep_out)
            near_.push_back(grown(bounds(region), footprint_reach(robot)));
    }
    bool in_keep_out(const Pose& pose) const {
        for (std::size_t k = 0; k < near_.size(); ++k)
            if (contains(near_[k], pose.at) && !keeps_off(robot_, pose.at, pose.heading, area_.keep_out[k]))
                return true;
        return false;
    }
    bool over_border(const Pose& pose) const {
        return !strandline::stays_within(robot_, pose.at, pose.heading, area_.border);
    }

  private:
    const DriveArea& area_;
    const Robot& robot_;
    std::vector<Box> near_;
};

/// Samples of one stroke, or of the drive between two, that are where they must not be.
struct Trespass {
    int stroke, next;  ///< next: of a drive, the stroke it leads to, -1: none; of a stroke itself: the same
    Point at;          ///< of the first
    double metres = 0;
    bool keep_out;
};

std::string name_of(const Plan& plan, int stroke) {
    const int element = plan.strokes[static_cast<std::size_t>(stroke)].element;
    return fmt::format("\"{}\"", plan.drawing.elements[static_cast<std::size_t>(element)].id);
}

std::string name_of(const Plan& plan, const Trespass& found) {
    if (found.stroke >= 0 && found.stroke == found.next) return "drawing " + name_of(plan, found.stroke);
    return fmt::format("the drive from {} to {}",
                       found.stroke < 0 ? "where it is parked" : name_of(plan, found.stroke),
                       found.next < 0 ? "the exit" : name_of(plan, found.next));
}

std::vector<Trespass> trespasses(const Plan& plan) {
    const DriveArea area = drive_area_of(plan);
    const Standing standing(area, plan.robot);
    // by sample: the next stroke to be drawn
    const std::vector<Sample>& samples = plan.samples;
    std::vector<int> next(samples.size(), -1);
    for (std::size_t i = samples.size(); i-- > 0;)
        next[i] = samples[i].stroke >= 0 ? samples[i].stroke : i + 1 < samples.size() ? next[i + 1] : -1;
    std::vector<Trespass> list;
    int before = -1;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& s = samples[i];
        if (s.stroke >= 0) before = s.stroke;
        const bool in_keep_out = standing.in_keep_out(s.pose);
        if (!in_keep_out && !standing.over_border(s.pose)) continue;
        if (list.empty() || list.back().stroke != before || list.back().next != next[i] ||
            list.back().keep_out != in_keep_out)
            list.push_back({before, next[i], s.pose.at, 0, in_keep_out});
        if (i + 1 < samples.size()) list.back().metres += distance(s.pose.at, samples[i + 1].pose.at);
    }
    return list;
}

void measure_ends(Plan& plan) {
    Figures& f = plan.figures;
    const std::vector<Sample>& samples = plan.samples;
    const auto draws = [](const Sample& s) { return s.motion == Motion::draw; };
    const auto first = std::ranges::find_if(samples, draws);
    const auto last = std::find_if(samples.rbegin(), samples.rend(), draws).base();
    const auto driven = [](auto from, auto to) {
        double sum = 0;
        for (auto at = from; at != to && at + 1 != to; ++at) sum += distance(at->pose.at, (at + 1)->pose.at);
        return sum;
    };
    if (first == samples.end()) return;
    if (plan.options.park.parked) f.in_driven = driven(samples.begin(), first + 1);
    if (plan.options.park.exit != "none") f.out_driven = driven(last, samples.end());
}

}  // namespace

Outcome<void> valid_surroundings(const Options& options) {
    if (options.park.exit == "parked" && !options.park.parked)
        return fail("park.exit", "the robot is parked nowhere", "set park.x, park.y and park.heading");
    return {};
}

double clearance_of(const Options& options, const Robot& robot) {
    return options.avoid.clearance < 0 ? wheel_reach(robot) : options.avoid.clearance;
}

void add_surroundings(order::Job& job, const Drawing& drawing, const Options& options, const Robot& robot) {
    const DriveArea area = drive_area_of(drawing, options, robot);
    const auto whole = [](const std::vector<Region>& regions) {
        Regions all;
        for (const Region& region : regions) {
            std::vector<Polygon> outlines{region.outer};
            outlines.insert(outlines.end(), region.holes.begin(), region.holes.end());
            const Regions one = resolved(outlines, FillRule::even_odd);
            all = all.empty() ? one : united(all, one);
        }
        return all;
    };
    job.keep_out = whole(area.keep_out);
    if (const Regions field = whole({area.border}); !field.empty())
        job.field = *std::ranges::max_element(field, {}, [](const Region& r) { return strandline::area(r); });
    const Options::Park& park = options.park;
    if (park.parked) job.parked = Pose{{park.x, park.y}, park.heading};
    if (park.exit == "parked")
        job.exits = {*job.parked, {job.parked->at, job.parked->heading + pi}};
    else if (park.exit == "pose")
        job.exits = {{{park.exit_x, park.exit_y}, park.exit_heading}};
    else if (park.exit == "outside")
        job.exits = allowed(exits_of(drawing, footprint_reach(robot)), area, robot);
}

bool stays_within(const std::vector<Sample>& samples, const DriveArea& area, const Robot& robot) {
    const Standing standing(area, robot);
    return std::ranges::none_of(samples, [&](const Sample& sample) {
        return standing.in_keep_out(sample.pose) || standing.over_border(sample.pose);
    });
}

void take_surroundings(Plan& plan) {
    measure_ends(plan);
    constexpr std::size_t most_named = 8;
    std::size_t named = 0;
    const std::vector<Trespass> found = trespasses(plan);
    for (const Trespass& trespass : found) {
        plan.blemishes.push_back({trespass.keep_out ? "the robot is in a keep-out, metres"
                                                    : "the robot is over the field's border, metres",
                                  trespass.at, trespass.metres});
        if (++named > most_named) continue;
        plan.warnings.push_back(
            {trespass.keep_out ? "field.keep_out" : "field.border",
             fmt::format("{} takes the robot {} from ({:.2f}, {:.2f}) on, for {:.2f} m",
                         name_of(plan, trespass), trespass.keep_out ? "into a keep-out" : "over the border",
                         trespass.at.x, trespass.at.y, trespass.metres)});
    }
    if (named > most_named)
        plan.warnings.push_back({"field", fmt::format("the same at {} more places", named - most_named)});
}

}  // namespace strandline::pipeline
