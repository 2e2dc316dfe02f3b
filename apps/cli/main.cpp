// The command line: what can be written, not what is done. Every command fills its arguments and returns its
// exit code.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <system_error>

#include "commands.hpp"
#include "console.hpp"
#include "drawing_commands.hpp"
#include "manual.hpp"
#include "sand_commands.hpp"
#include "stage_commands.hpp"

namespace {

using namespace strandline;
using namespace strandline::cli;

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
    serve->add_option(
        "--web", a.web,
        "folder of the editor's built pages; default: those that are installed, or that ./run built");
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
Exit codes: 0 done, 1 the input is at fault, 2 the call is at fault, 3 done, but something falls short, 130 a batch that
Ctrl-C ended.)");

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
    std::string robot, robot_output = "-";
    add_drawings(app, plan, batch, text, trace, common, chosen);
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
    robots
        ->add_option("-o,--output", robot_output,
                     "a profile file, or a drawing of the robot to scale where it ends in .svg; -: stdout")
        ->capture_default_str();
    robots->footer(
        "With --json: a robot as in a plan file (docs/plan-format.md); without a name a list of them.");
    robots->callback([&] { chosen = [&] { return show_robot(robot, robot_output, common); }; });
#ifdef STRANDLINE_EDITOR
    ServeArguments served;
    add_serve(app, served, common, chosen);
#endif
    add_stages(app, tour, fill, connect, convert, common, chosen);
    std::string kind;
    add_manual(app, kind, chosen);

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
    } catch (const std::filesystem::filesystem_error& error) {
        return complain({error.path1().string(), error.code().message(), "check the name and the rights"},
                        bad_input);
    } catch (const std::system_error& error) {  // printing to a full disk
        return complain({"stdout", std::string("cannot be written: ") + error.what(), "check the space left"},
                        bad_input);
    }
}
