// A plan as a table of samples, and its figures.
#include <cmath>

#include "base/text/text.hpp"
#include "machine/pins/pins.hpp"
#include "result/formats/formats.hpp"
#include "result/formats/plan_schema.hpp"

namespace strandline::formats {
namespace {

/// Length of the circular arc between two poses: the chord, made longer by the turn.
double arc_between(Pose a, Pose b) {
    const double half = wrap_angle(b.heading - a.heading) / 2, chord = distance(a.at, b.at);
    return std::abs(half) < 1e-6 ? chord : chord * half / std::sin(half);
}

class FigureLines {
  public:
    explicit FigureLines(Text& text) : text_(text) {}
    void operator()(const char* key, int value) {
        line(key), add_number(text_, static_cast<long long>(value));
    }
    void operator()(const char* key, double value) { line(key), add_number(text_, value); }
    void operator()(const char* key, bool value) { line(key), add(text_, value ? "true" : "false"); }
    void operator()(const char* key, const std::string& value) { line(key), add_string(text_, value); }
    void operator()(const char* key, const Warnings& warnings) {
        line(key);
        add(text_, "[");
        for (std::size_t i = 0; i < warnings.size(); ++i) {
            add(text_, i > 0 ? ",\n  " : "\n  ");
            add_string(text_, sentence(warnings[i]));
        }
        add(text_, warnings.empty() ? "]" : "\n]");
    }

  private:
    void line(const char* key) {
        add(text_, text_.empty() ? "{\n\"" : ",\n\"");
        add(text_, key);
        add(text_, "\": ");
    }
    Text& text_;
};

}  // namespace

std::string write_csv(const Plan& plan) {
    constexpr int micrometres = 6;
    Text text;
    add(text, "s,t,x,y,heading,curvature,v,omega,pins,rake_x,rake_y,motion,stroke,told\n");
    double s = 0;
    const std::vector<Sample> told = pins::told(plan.robot, plan.samples);
    std::size_t done = 0;  // the plan's own sample that holds here: what the pins do
    for (std::size_t i = 0; i < told.size(); ++i) {
        const Sample& sample = told[i];
        if (i > 0) s += arc_between(told[i - 1].pose, sample.pose);
        while (done + 1 < plan.samples.size() && plan.samples[done + 1].t <= sample.t) ++done;
        for (const double value : {s, sample.t, sample.pose.at.x, sample.pose.at.y, sample.pose.heading,
                                   sample.curvature, sample.speed, sample.turn_rate}) {
            add_fixed(text, value, micrometres);
            add(text, ",");
        }
        add_number(text, static_cast<long long>(plan.samples[done].mask));
        for (const double value : {sample.rake.x, sample.rake.y}) {
            add(text, ",");
            add_fixed(text, value, micrometres);
        }
        add(text, ",");
        add(text, name_of(sample.motion));
        add(text, ",");
        add_number(text, static_cast<long long>(sample.stroke));
        add(text, ",");
        add_number(text, static_cast<long long>(sample.mask));
        add(text, "\n");
    }
    return text;
}

std::string write_figures(const Plan& plan) {
    Text text;
    FigureLines line(text);
    line("program", plan.program);
    line("title", plan.title);
    line("robot", plan.robot.name);
    line("canvas_width", plan.drawing.canvas.width);
    line("canvas_height", plan.drawing.canvas.height);
    line("scale", plan.drawing.scale);
    if (plan.drawing.scale_denominator) line("scale_denominator", *plan.drawing.scale_denominator);
    fields(plan.figures, line);
    line("samples", static_cast<int>(plan.samples.size()));
    line("undrivable", static_cast<int>(plan.undrivable.size()));
    line("bare", static_cast<int>(plan.bare.size()));
    line("idle_edits", static_cast<int>(plan.idle_edits.size()));
    line("warnings", plan.warnings);
    add(text, "\n}\n");
    return text;
}

}  // namespace strandline::formats
