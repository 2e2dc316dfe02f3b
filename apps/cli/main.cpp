// The command line: what can be written, not what is done. Every command fills its arguments and returns its
// exit code.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <iostream>
#include <system_error>

#include "commands.hpp"
#include "console.hpp"
#include "sand_commands.hpp"
#include "stage_commands.hpp"

namespace {

using namespace strandline;
using namespace strandline::cli;

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
    plan->add_option("--robot", a.robot,
                     "beachbot, plotter, turf, diffdrive, or a profile file (.toml); default beachbot");
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
    plan->footer(R"(Examples:
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

void add_results(CLI::App& app, ExportArguments& e, LocateArguments& l, CheckArguments& c, RenderArguments& r,
                 const Common& common, std::function<int()>& chosen) {
    CLI::App* exported = app.add_subcommand("export", "plan -> what robots, maps and other programs read");
    exported->add_option("input", e.input, "plan file, or -")->required();
    exported->add_option("--format", e.format, "see strandline formats")->required();
    exported
        ->add_option("-o,--output", e.output,
                     "file, or - for stdout. beachbot: NAME.txt gives NAME_robot.txt and NAME_rake.txt")
        ->capture_default_str();
    exported->add_option("--path", e.path, "rake or robot, for trace")
        ->check(CLI::IsMember({"rake", "robot"}))
        ->capture_default_str();
    exported
        ->add_option("--set", e.settings,
                     "key=value, over the plan's own; keys: site.*, mission.*, gcode.*, thr.*, nav.*")
        ->allow_extra_args(false);
    exported->add_option("--config", e.configs, "settings file (.toml), of which the same groups are read")
        ->allow_extra_args(false);
    exported->footer(R"(Examples:
  strandline export lion.json --format beachbot -o lion.txt
  strandline export lion.json --format geojson --config site.toml -o lion.geojson
  strandline export lion.json --format wpl --config site.toml --set mission.servo=5 -o lion.waypoints)");
    exported->callback([&] { chosen = [&] { return export_plan(e, common); }; });
    CLI::App* list = app.add_subcommand("formats", "lists the export formats");
    list->footer("With --json: [{\"name\", \"what\"}, ...]");
    list->callback([&] { chosen = [&] { return list_formats(common); }; });

    CLI::App* located = app.add_subcommand(
        "locate", "measured flags -> where on earth the canvas lies, and what poles to keep out of");
    located->add_option("input", l.input, "CSV: name,x,y,latitude,longitude,radius (or east,north), or -")
        ->required();
    located->add_option("-o,--output", l.output, "settings file for plan and export, or - for stdout")
        ->capture_default_str();
    located->add_option("--most", l.most, "exit 3 when a flag is farther off than this; default 10cm");
    located->add_option("--set", l.settings, "site.latitude=... and others that local metres count from")
        ->allow_extra_args(false);
    located->footer(
        R"(x, y: where the flag stands on the canvas; empty for a pole that is only to be kept out of.
Examples:
  strandline locate flags.csv -o site.toml
  strandline plan lion.svg --config site.toml -o lion.json)");
    located->callback([&] { chosen = [&] { return locate(l, common); }; });

    CLI::App* check = app.add_subcommand("check", "proves a plan from its file alone");
    check->add_option("input", c.input, "plan file, or -")->required();
    check->footer(
        "Exit 0: sound (blemishes are listed), 3: a law is broken.\nExample:\n  strandline check lion.json "
        "--json");
    check->callback([&] { chosen = [&] { return cli::check(c, common); }; });

    CLI::App* render = app.add_subcommand("render", "plan -> picture");
    render->add_option("input", r.input, "plan file, or -")->required();
    render->add_option("-o,--output", r.output, "picture.svg, picture.png or picture.pdf")->required();
    render->add_option("--pixels", r.pixels, "longer side of a PNG")
        ->check(CLI::Range(64, 16000))
        ->capture_default_str();
    render->footer("Example:\n  strandline render lion.json -o lion.png --pixels 2000");
    render->callback([&] { chosen = [&] { return cli::render(r, common); }; });
}

#ifdef STRANDLINE_EDITOR
void add_serve(CLI::App& app, ServeArguments& a, const Common& common, std::function<int()>& chosen) {
    CLI::App* serve =
        app.add_subcommand("serve", "opens the editor: see the drive and change it, in the browser");
    serve->add_option("input", a.input,
                      "drawing (SVG, PNG, JPEG) or project (.strandline); none: begin with bare sand");
    serve->add_option("--port", a.port, "of the address that is printed; 0: any that is free")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    serve->add_option("--folder", a.folder, "where projects are kept; default: beside the input, or here");
    serve->add_option("--host", a.host, "0.0.0.0 lets tablets on the network in; needs --token")
        ->capture_default_str();
    serve->add_option("--token", a.token, "what who opens the editor has to know");
    serve->add_option("--web", a.web, "folder of the editor's built pages; default: where ./run built them");
    serve->footer(R"(Every change is kept in NAME.strandline as it is made; Ctrl-C ends the server.
Examples:
  strandline serve lion.svg
  strandline serve lion.strandline --port 9000
  strandline serve --folder ~/beach --host 0.0.0.0 --token sand)");
    serve->callback([&] { chosen = [&] { return cli::serve(a, common); }; });
}
#endif

/// What is wrong with the call, and where its help is.
Error misread(const CLI::App& app, int argc, char** argv, const CLI::ParseError& error) {
    const std::string first = argc > 1 ? argv[1] : "";
    const auto commands =
        app.get_subcommands([&](const CLI::App* command) { return command->get_name() == first; });
    if (!first.empty() && first[0] != '-' && commands.empty())
        return {first, "there is no such command", "strandline --help lists them"};
    if (first.empty()) return {"", "a command is missing", "strandline --help lists them"};
    return {first, error.what(),
            commands.empty() ? "see strandline --help" : "see strandline " + first + " --help"};
}

/// What was printed must have arrived.
int finished(int code) {
    std::cout.flush();
    if (std::fflush(stdout) == 0 && std::cout) return code;
    return complain({"stdout", "cannot be written whole", "check the space left"}, bad_input);
}

}  // namespace

// What is not foreseen below ends the program, with its name on stderr:
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    CLI::App app{"Strandline: a drawing becomes one drivable path for a drawing robot"};
    app.set_version_flag("--version", "strandline " STRANDLINE_VERSION);
    app.require_subcommand(1);
    app.fallthrough();
    Common common;
    app.add_flag("-q,--quiet", common.quiet, "only errors");
    app.add_flag("-v,--verbose", common.verbose, "more");
    app.add_flag("--json", common.json, "figures and lists as JSON");
    app.footer(R"(Start here:
  strandline plan drawing.svg -o plan.json && strandline render plan.json -o plan.png
Exit codes: 0 done, 1 the input is at fault, 2 the call is at fault, 3 done, but something falls short.)");

    std::function<int()> chosen;
    PlanArguments plan;
    BatchArguments batch;
    TextArguments text;
    TraceArguments trace;
    ExportArguments exported;
    LocateArguments located;
    CheckArguments check;
    RenderArguments render;
    SimulateArguments simulate;
    ResumeArguments resume;
    SplitArguments split;
    TourArguments tour;
    FillArguments fill;
    ConnectArguments connect;
    ConvertArguments convert;
    std::string robot;
    add_plan(app, plan, batch, common, chosen);
    add_text(app, text, common, chosen);
    add_trace(app, trace, common, chosen);
    add_results(app, exported, located, check, render, common, chosen);
    add_sand(app, simulate, resume, split, common, chosen);
    CLI::App* settings = app.add_subcommand("settings", "lists everything that can be set");
    settings->footer(
        "With --json: [{\"key\", \"kind\", \"unit\", \"default\", \"low\", \"high\", \"choices\", "
        "\"meaning\"}, ...]: "
        "metres, radians, seconds;\n\"low\" and \"high\" for numbers, \"choices\" for choices alone.");
    settings->callback([&] { chosen = [&] { return list_settings(common); }; });
    CLI::App* robots =
        app.add_subcommand("robots", "lists the built-in robots, or prints one as a profile file");
    robots->add_option("name", robot, "a built-in robot or a profile file");
    robots->footer(
        "With --json: a robot as in a plan file (docs/plan-format.md); without a name a list of them.");
    robots->callback([&] { chosen = [&] { return show_robot(robot, common); }; });
#ifdef STRANDLINE_EDITOR
    ServeArguments served;
    add_serve(app, served, common, chosen);
#endif
    add_stages(app, tour, fill, connect, convert, common, chosen);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return finished(app.exit(error));
        return complain(misread(app, argc, argv, error), bad_call);
    }
    try {
        return finished(chosen());
    } catch (const std::bad_alloc&) {
        return complain({"", "not enough memory for this input", "make it simpler"}, bad_input);
    } catch (const std::system_error& error) {  // printing to a full disk
        return complain({"stdout", std::string("cannot be written: ") + error.what(), "check the space left"},
                        bad_input);
    }
}
