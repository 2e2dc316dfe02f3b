#pragma once
// What each command of the program takes (filled by main.cpp from the command line) and the function that
// does it. A command returns its exit code: 0 done, 1 the input is at fault, 2 the call is at fault, 3 done,
// but something falls short, 130 a batch that Ctrl-C ended.
#include <optional>
#include <string>
#include <vector>

namespace strandline::cli {

enum Exit { done = 0, bad_input = 1, bad_call = 2, falls_short = 3, stopped_by_user = 130 };

/// What every command understands.
struct Common {
    bool quiet = false, verbose = false, json = false;
};

struct TraceArguments {
    std::string input, output, threshold;
    bool invert = false;
    std::vector<std::string> settings;  ///< key=value
};
int trace(const TraceArguments& arguments, const Common& common);

/// How text is lettered.
struct LetteringArguments {
    std::string text;  ///< newlines also as \n; - is stdin
    std::string font = "rowmans", height, align = "left", letter_spacing, stroke_width;
    double line_spacing = 1.6;
};
struct TextArguments {
    LetteringArguments lettering;
    std::string output = "-";
    bool list = false;
};
int text(const TextArguments& arguments, const Common& common);

struct PlanArguments {
    LetteringArguments lettering;  ///< of --text, in the place of a drawing
    std::string input, output = "-", robot, canvas, place, margin, dpi, start, end;
    std::string border, park, exit;
    std::vector<std::string> configs;  ///< settings files, later ones over earlier ones
    std::vector<std::string> keep_outs;
    std::vector<std::string> settings;    ///< key=value, also robot.field=value
    std::vector<std::string> links;       ///< A:V=B:W
    std::vector<std::string> entries;     ///< A:V
    std::vector<std::string> directions;  ///< A=forward|backward|ccw|cw
    std::string avoid, order, method;
    std::string occlusion;
    std::vector<std::string> layers, rules;
    bool invert = false, strict = false, open = false;
    std::string max_time, split;
};
int plan(const PlanArguments& arguments, const Common& common);

/// Several drawings into one folder; what is asked of each is in PlanArguments.
struct BatchArguments {
    std::vector<std::string> inputs;
    std::string folder;
    int jobs = 1;        ///< plans made at the same time
    bool force = false;  ///< also those that are up to date
};
int plan_all(const BatchArguments& batch, const PlanArguments& each, const Common& common);

struct ExportArguments {
    std::string input, output = "-", format, path = "rake";
    std::vector<std::string> configs, settings;  ///< files; key=value
};
int export_plan(const ExportArguments& arguments, const Common& common);
int list_formats(const Common& common);

struct LocateArguments {
    std::string input, output = "-", most;
    std::vector<std::string> settings;  ///< site.*=value: what local metres count from
};
int locate(const LocateArguments& arguments, const Common& common);

struct CheckArguments {
    std::string input;
};
int check(const CheckArguments& arguments, const Common& common);

struct RenderArguments {
    std::string input, output;
    int pixels = 1200;
};
int render(const RenderArguments& arguments, const Common& common);

struct SimulateArguments {
    std::vector<std::string> inputs;  ///< a plan, the pair of robot texts, or a CSV
    std::string output, flaws, log, against, cell;
    PlanArguments wishes;              ///< robot, canvas, place and settings for drives that are no plan
    std::optional<std::string> noise;  ///< metres; "": the robot's
    std::string wander, delay;
    unsigned long long seed = 1;
    bool late_pins = false;
    int pixels = 1200;
    double seconds = 15;  ///< of a film
};
int simulate(const SimulateArguments& arguments, const Common& common);

struct ResumeArguments {
    std::string input, output = "-", from;
};
int resume(const ResumeArguments& arguments, const Common& common);
struct SplitArguments {
    std::string input, output, every;
};
int split(const SplitArguments& arguments, const Common& common);

int list_settings(const Common& common);
/// Without a name: the built-in names; with one: its profile as TOML, or a drawing into an .svg file. As
/// JSON: the robots themselves.
int show_robot(const std::string& name, const std::string& output, const Common& common);

struct TourArguments {
    std::string input, output = "-";
    unsigned long long moves = 0, seed = 1;
    std::string time_limit;  ///< duration text, "" = none
    std::string method = "best", order = "any", entries = "vertices";
    int threads = 1;
    std::string write_tsplib, read_tour;  ///< files; "" = none
};
int tour(const TourArguments& arguments, const Common& common);

struct FillArguments {
    std::string input, output = "-", style = "rings", inset = "offset", vehicle = "free", width, spacing,
                       direction;
    std::string partition = "fitted", cuts, segments, narrow = "single-pass", join = "half-step";
    bool one_stroke = false;
    double shift = 3;         ///< rake widths
    std::optional<int> pins;  ///< liftable, with masks; absent: a solid rake
};
int fill(const FillArguments& arguments, const Common& common);

struct ConnectArguments {
    std::string input, output = "-", style = "bounded", radius;
    std::optional<double> sharpness;
    double extra_length = 0.1;  ///< fair
    bool quick = false;         ///< bounded, not refined
};
int connect(const ConnectArguments& arguments, const Common& common);

struct ConvertArguments {
    std::string input, output = "-", robot = "beachbot";
};
int convert(const ConvertArguments& arguments, const Common& common);

struct ServeArguments {
    std::string input;   ///< a drawing, a project, or nothing
    std::string folder;  ///< of projects; "": the input's own
    std::string host = "127.0.0.1", token, web;
    int port = 8014;
};
int serve(const ServeArguments& arguments, const Common& common);

}  // namespace strandline::cli
