// The command line of what begins with a drawing: what can be written, not what is done.
#include "drawing_commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "machine/robot/robot.hpp"

namespace strandline::cli {
namespace {

/// How text is lettered; the text itself is the caller's.
void add_lettering(CLI::App* command, LetteringArguments& a) {
    command->add_option("--font", a.font, "a Hershey font (strandline text --list), or a .jhf file")
        ->capture_default_str();
    command->add_option("--height", a.height, "from base line to cap line; default 1m");
    command->add_option("--align", a.align, "left, centre or right: of several lines")
        ->check(CLI::IsMember({"left", "centre", "right"}))
        ->capture_default_str();
    command->add_option("--line-spacing", a.line_spacing, "from base line to base line, in heights")
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    command->add_option("--letter-spacing", a.letter_spacing, "added behind each letter (5cm)");
    command->add_option("--stroke-width", a.stroke_width,
                        "of the SVG's lines; the robot's rake rules count its millimetres; default 1mm");
}

void add_text(CLI::App& app, TextArguments& a, const Common& common, std::function<int()>& chosen) {
    CLI::App* text = app.add_subcommand("text", "words -> SVG of single lines, in the Hershey fonts");
    text->add_option("text", a.lettering.text, "what to write; \\n begins a new line; - is stdin");
    text->add_option("-o,--output", a.output, "SVG file, or - for stdout")->capture_default_str();
    add_lettering(text, a.lettering);
    text->add_flag("--list", a.list, "lists the fonts");
    text->footer(R"(Examples:
  strandline text "Hello\nbeach" --font scripts --height 1m -o hello.svg
  strandline text "LOW TIDE" --font gothiceng --height 60cm --align centre | strandline plan - -o tide.json
  strandline text --list
With --list --json: [{"name", "what"}, ...])");
    text->callback([&] { chosen = [&] { return cli::text(a, common); }; });
}

void add_trace(CLI::App& app, TraceArguments& a, const Common& common, std::function<int()>& chosen) {
    CLI::App* trace = app.add_subcommand("trace", "picture -> SVG of its areas of ink: what plan would take");
    trace->add_option("input", a.input, "PNG or JPEG file, or - for stdin")->required();
    trace->add_option("-o,--output", a.output, "SVG file, or - for stdout")->required();
    trace->add_option("--threshold", a.threshold, "0 to 1: ink is darker than this; default: found (Otsu)");
    trace->add_flag("--invert", a.invert, "ink is what is bright");
    trace->add_option("--set", a.settings, "key=value; keys: trace.* of strandline settings");
    trace->footer(R"(Examples:
  strandline trace photo.jpg -o preview.svg
  strandline trace scan.png --threshold 0.6 --set trace.despeckle=30 -o preview.svg
The same settings, given to plan, plan the same areas:
  strandline plan scan.png --set trace.threshold=0.6 --set trace.despeckle=30 -o scan.json)");
    trace->callback([&] { chosen = [&] { return cli::trace(a, common); }; });
}

void add_plan(CLI::App& app, PlanArguments& a, BatchArguments& b, const Common& common,
              std::function<int()>& chosen) {
    CLI::App* plan =
        app.add_subcommand("plan", "drawing -> plan: what to draw, in which order, how to drive");
    // One value each, so that files may follow.
    const auto repeated = [&](const char* name, std::vector<std::string>& values, const char* what) {
        plan->add_option(name, values, what)->allow_extra_args(false);
    };
    plan->add_option("input", b.inputs,
                     "SVG file or picture (PNG, JPEG), or - for stdin; several with --out-dir");
    plan->add_option("--text", a.lettering.text,
                     "words in the place of a file; with --height at that size (--place actual)");
    add_lettering(plan, a.lettering);
    plan->add_option("-o,--output", a.output, "plan file (JSON), or - for stdout")->capture_default_str();
    plan->add_option(
        "--robot", a.robot,
        fmt::format("{}, or a profile file (.toml); default beachbot", fmt::join(builtin_robots(), ", ")));
    repeated("--config", a.configs, "settings file (.toml); may be repeated, later ones win");
    repeated("--set", a.settings,
             "key=value; keys: strandline settings. robot.FIELD=value changes the robot");
    plan->add_option("--canvas", a.canvas,
                     "WIDTHxHEIGHT with units (14mx14m, 20x10) or a paper size (A4, A3-landscape)");
    plan->add_option("--margin", a.margin, "kept free round the drawing (--place fit)");
    plan->add_option("--place", a.place, "fit | actual | width=10m | scale=1:50");
    repeated("--layer", a.layers, "draw only this layer (* for any letters); may be repeated");
    repeated("--rule", a.rules,
             "layer=NAME: pins=3 or colour=#f00000: tool=2, fill-style=zigzag; may be repeated");
    plan->add_option("--avoid", a.avoid,
                     "on | off: off drives over finished areas and lines, the shortest way");
    plan->add_option("--order", a.order, "free | grouped: neighbouring strokes are finished together")
        ->check(CLI::IsMember({"free", "grouped"}));
    plan->add_option("--method", a.method, "best | exact | nearest | file: how the order is found");
    plan->add_option("--occlusion", a.occlusion, "on | off: off draws what later shapes cover too");
    plan->add_flag("--invert", a.invert, "the drawing is light on dark: rake what is bright");
    plan->add_option("--dpi", a.dpi, "px to the inch in the SVG, for --place actual; default 96");
    plan->add_option("--start", a.start, "X,Y: begin near this point (metres, origin lower left)");
    plan->add_option("--end", a.end, "X,Y: end near this point");
    plan->add_option("--park", a.park, "X,Y,HEADING: the robot is parked there, and the drive begins there");
    plan->add_option("--exit", a.exit, "parked | outside | X,Y,HEADING: where the drive ends");
    plan->add_option("--border", a.border,
                     "\"X,Y X,Y X,Y\" or a .geojson file: where the robot may drive; default: the canvas and "
                     "canvas.run_out");
    repeated("--keep-out", a.keep_outs,
             "\"X,Y X,Y X,Y\" or a .geojson file: where the robot must not go; may be repeated");
    repeated("--link", a.links, "A:V=B:W: drive from node V of element A to node W of element B");
    repeated("--entry", a.entries, "A:V: enter element A at its node V (-1: its last)");
    repeated("--direction", a.directions, "A=forward|backward for lines, A=ccw|cw for closed ones");
    plan->add_flag("--strict", a.strict,
                   "exit 3 when check finds a fault, finished ground is driven over, or anything was done "
                   "another way than asked");
    plan->add_option("--max-time", a.max_time, "the largest drawing whose drive takes no longer (40min)");
    plan->add_option(
        "--split", a.split,
        "also NAME-1.json, NAME-2.json ...: parts of at most 30min, or 200m, cut at stroke ends");
    CLI::Option* folder =
        plan->add_option("--out-dir", b.folder,
                         "plans of all drawings into this folder; what is up to date is not planned again");
    plan->add_option("-j,--jobs", b.jobs, "so many plans at once, each with memory of its own")
        ->check(CLI::Range(1, 64))
        ->capture_default_str()
        ->needs(folder);
    plan->add_flag("--force", b.force, "what is up to date too")->needs(folder);
    plan->add_flag("--open", a.open, "write a picture beside the plan and open it");
    plan->footer(
        R"(Ctrl-C while it plans ends the search, not the call: the best plan so far is written and the exit code is that of
any plan. Its summary says "stopped early: not reproducible". With --out-dir what is half-done is given up: exit code 130.
Examples:
  strandline plan lion.svg -o lion.json
  strandline plan logo.svg -o logo.json --canvas 20x20 --set fill.style=zigzag --set fill.spacing=36cm
  strandline plan card.svg --robot plotter --canvas A5 --margin 10mm -o card.json
  strandline plan eye.svg --link iris:0=lid:-1 --direction lid=backward -o eye.json
  strandline plan --text "Hello\nbeach" --font scripts --height 1m -o hello.json
  strandline plan sun.svg --keep-out "3,3 5,3 5,6" --park 0,0,90deg --exit outside -o sun.json
  strandline plan photo.jpg --set trace.despeckle=50 -o photo.json
  cat drawing.svg | strandline plan - | strandline check -
  strandline plan drawings/*.svg --out-dir plans -j 2)");
    plan->callback([&] {
        chosen = [&] {
            if (!b.folder.empty() || b.inputs.size() > 1) return plan_all(b, a, common);
            if (!b.inputs.empty()) a.input = b.inputs.front();
            return cli::plan(a, common);
        };
    });
}

}  // namespace

void add_drawings(CLI::App& app, PlanArguments& plan, BatchArguments& batch, TextArguments& text,
                  TraceArguments& trace, const Common& common, std::function<int()>& chosen) {
    add_plan(app, plan, batch, common, chosen);
    add_text(app, text, common, chosen);
    add_trace(app, trace, common, chosen);
}

}  // namespace strandline::cli
