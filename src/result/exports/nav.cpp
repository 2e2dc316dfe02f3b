// Paths for ROS 2 as YAML: nav_msgs/msg/Path, and goals of nav2_msgs/action/FollowPath. One flow mapping a
// pose; numbers always with a point, as readers of YAML 1.1 take 1e-05 for a word.
#include <fmt/format.h>

#include <cmath>

#include "base/text/text.hpp"
#include "machine/pins/pins.hpp"
#include "result/exports/spans.hpp"

namespace strandline::exports {
namespace {

constexpr int metre_decimals = 6, quaternion_decimals = 9;

class Paths {
  public:
    explicit Paths(const Plan& plan) : options_(plan.options.nav), site_(plan.options.site.at) {}

    void line(std::string_view text) {
        add(text_, text);
        add(text_, "\n");
    }
    void named(std::string_view key, const std::string& value) {
        add(text_, key);
        add(text_, ": ");
        add_string(text_, value);
        add(text_, "\n");
    }
    /// header and poses, each line behind `indent`.
    void path(const std::vector<Sample>& samples, std::size_t first, std::size_t last,
              std::string_view indent) {
        add(text_, indent);
        header(0);
        add(text_, "\n");
        add(text_, indent);
        line("poses:");
        for (std::size_t i = first; i <= last; ++i) {
            if (i > first && samples[i].pose == samples[i - 1].pose) continue;  // it stands and waits
            add(text_, indent);
            pose(samples[i]);
        }
    }
    std::string done() { return std::move(text_); }

  private:
    void header(double t) {
        constexpr double second = 1e9;
        const long long nanoseconds = std::llround(t * second), whole = 1'000'000'000;
        add(text_, "header: {stamp: {sec: ");
        add_number(text_, nanoseconds / whole);
        add(text_, ", nanosec: ");
        add_number(text_, nanoseconds % whole);
        add(text_, "}, frame_id: ");
        add_string(text_, options_.frame);
        add(text_, "}");
    }
    void pose(const Sample& sample) {
        const Point at = to_local(site_, sample.pose.at);
        const double half = local_heading(site_, sample.pose.heading) / 2;
        add(text_, "- {");
        header(sample.t);
        add(text_, ", pose: {position: {x: ");
        add_fixed(text_, at.x, metre_decimals);
        add(text_, ", y: ");
        add_fixed(text_, at.y, metre_decimals);
        add(text_, ", z: 0.0}, orientation: {x: 0.0, y: 0.0, z: ");
        add_fixed(text_, std::sin(half), quaternion_decimals);
        add(text_, ", w: ");
        add_fixed(text_, std::cos(half), quaternion_decimals);
        add(text_, "}}}\n");
    }

    const Options::Nav& options_;
    const Site& site_;
    Text text_;
};

void add_goal(Paths& out, const Plan& plan, const std::vector<Sample>& samples, std::size_t first,
              std::size_t last) {
    out.line("path:");
    out.path(samples, first, last, "  ");
    out.named("controller_id", plan.options.nav.controller);
    out.named("goal_checker_id", plan.options.nav.goal_checker);
}

Warnings lost(const Plan& plan) {
    if (plan.samples.empty()) return {{"plan", "nothing is driven: the path has no poses"}};
    const int times = times_backing(plan.samples);
    if (times == 0) return {};
    return {
        {"nav", fmt::format("the robot backs up {}, and its poses keep looking ahead: the controller must "
                            "follow cusps (Regulated Pure Pursuit: allow_reversing)",
                            counted(times, "time"))}};
}

}  // namespace

Written nav_path(const Plan& plan) {
    Paths out(plan);
    if (plan.samples.empty())
        out.line("header: {stamp: {sec: 0, nanosec: 0}, frame_id: \"\"}\nposes: []");
    else
        out.path(plan.samples, 0, plan.samples.size() - 1, "");
    return {{{"_path.yaml", out.done()}}, lost(plan)};
}

Written follow_path(const Plan& plan) {
    Paths out(plan);
    const bool one = plan.options.nav.goals == "one";
    const std::vector<Sample> samples = one ? plan.samples : pins::told(plan.robot, plan.samples);
    if (one && !samples.empty()) {
        add_goal(out, plan, samples, 0, samples.size() - 1);
    } else {
        const auto spans = spans_of(samples);
        for (std::size_t k = 0; k < spans.size(); ++k) {
            out.line("---");
            out.line("# goal " + std::to_string(k + 1) + " of " + std::to_string(spans.size()) + ": rake " +
                     (spans[k].down ? "down, stroke " + std::to_string(spans[k].stroke) : "up"));
            add_goal(out, plan, samples, spans[k].first, spans[k].last);
        }
    }
    return {{{"_goal.yaml", out.done()}}, lost(plan)};
}

}  // namespace strandline::exports
