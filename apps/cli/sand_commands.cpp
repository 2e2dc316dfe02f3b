// The command line of what happens to a finished plan in the sand: what can be written, not what is done.
#include "sand_commands.hpp"

#include <CLI/CLI.hpp>

namespace strandline::cli {
namespace {

void add_simulate(CLI::App& app, SimulateArguments& a, const Common& common, std::function<int()>& chosen) {
    CLI::App* simulate = app.add_subcommand(
        "simulate", "drives a plan, or a drive of any origin, and measures what it leaves in the sand");
    simulate->add_option("input", a.inputs, "plan file, or robot.txt rake.txt, or drive.csv")
        ->required()
        ->expected(1, 2);
    simulate->add_option(
        "-o,--output", a.output,
        "sand.png: the sand seen from above; drive.gif, or drive-%03d.png for a picture an instant: "
        "the drawing as it appears");
    simulate->add_option("--seconds", a.seconds, "of a film")
        ->check(CLI::Range(0.5, 3600.0))
        ->capture_default_str();
    simulate->add_option("--flaws", a.flaws, "flaws.png: what is wrong, each kind in a colour");
    simulate->add_option("--cell", a.cell, "of the raster; default 1cm, a sixth of a pin where that is less");
    simulate->add_option("--pixels", a.pixels, "longer side of a picture")
        ->check(CLI::Range(64, 16000))
        ->capture_default_str();
    simulate->add_option("--against", a.against, "drawing or plan that the sand is held against");
    simulate
        ->add_option("--noise", a.noise,
                     "let a controller drive; of each fix of its place, default the robot's fix_noise")
        ->expected(0, 1);
    simulate->add_option("--wander", a.wander, "of the slow drift of that place, default 1cm");
    simulate->add_option("--delay", a.delay, "of fixes, default 0.12s");
    simulate->add_option("--seed", a.seed, "of the noise")->capture_default_str();
    simulate->add_flag("--late-pins", a.late_pins, "pins are told when they should be there, not before");
    simulate->add_option("--log", a.log, "drive.csv: how the controller drove");
    simulate->add_option("--robot", a.wishes.robot, "of a drive that is no plan");
    simulate->add_option("--canvas", a.wishes.canvas, "--against a drawing: as for plan");
    simulate->add_option("--place", a.wishes.place, "--against a drawing: as for plan");
    simulate->add_option("--margin", a.wishes.margin, "--against a drawing: as for plan");
    simulate->add_option("--set", a.wishes.settings, "--against a drawing: as for plan");
    simulate->footer(R"(Examples:
  strandline simulate lion.json -o sand.png --flaws flaws.png
  strandline simulate lion.json -o drive.gif --pixels 480
  strandline simulate lion.json --noise --seed 7 --log drive.csv
  strandline simulate lion.json --noise 0 --wander 0 --delay 0.12s
  strandline simulate lion_robot.txt lion_rake.txt --against lion.svg --json)");
    simulate->callback([&] { chosen = [&] { return cli::simulate(a, common); }; });
}

void add_parts(CLI::App& app, ResumeArguments& r, SplitArguments& s, const Common& common,
               std::function<int()>& chosen) {
    CLI::App* resume = app.add_subcommand("resume", "the rest of a plan, from a stroke on");
    resume->add_option("input", r.input, "plan file, or -")->required();
    resume->add_option("--from", r.from, "a time (12min), an element's id, or a place (3.5,2)")->required();
    resume->add_option("-o,--output", r.output, "plan file, or - for stdout")->capture_default_str();
    resume->footer(
        R"(The stroke that was being drawn is drawn again from its beginning; put the robot where the plan begins.
Example:
  strandline resume lion.json --from 4min -o rest.json)");
    resume->callback([&] { chosen = [&] { return cli::resume(r, common); }; });
    CLI::App* split = app.add_subcommand("split", "a plan in parts, cut at stroke ends");
    split->add_option("input", s.input, "plan file, or -")->required();
    split->add_option("--every", s.every, "the most that one part may be: 30min or 200m")->required();
    split->add_option("-o,--output", s.output, "NAME.json gives NAME-1.json, NAME-2.json ...")->required();
    split->footer("Example:\n  strandline split crab.json --every 20min -o crab.json");
    split->callback([&] { chosen = [&] { return cli::split(s, common); }; });
}

}  // namespace

void add_sand(CLI::App& app, SimulateArguments& simulate, ResumeArguments& resume, SplitArguments& split,
              const Common& common, std::function<int()>& chosen) {
    add_simulate(app, simulate, common, chosen);
    add_parts(app, resume, split, common, chosen);
}

}  // namespace strandline::cli
