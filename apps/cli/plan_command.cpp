#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <future>

#include "arguments.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "fonts.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "result/check/check.hpp"
#include "result/formats/formats.hpp"
#include "summary.hpp"

namespace strandline::cli {
namespace {

namespace fs = std::filesystem;

/// Settings file first, the command line over it, both over `defaults`.
Outcome<Wishes> gathered(const PlanArguments& a, const Options& defaults) {
    Wishes wishes;
    wishes.options = defaults;
    Outcome<void> done;
    if (!a.config.empty()) done = read_settings_file(wishes, a.config);
    if (!a.robot.empty()) wishes.robot = a.robot;
    if (done && !a.canvas.empty()) done = set_canvas(wishes.options, a.canvas);
    // Who says how high letters are wants them so.
    if (done && !a.lettering.text.empty() && !a.lettering.height.empty())
        done = set(wishes.options, "place.mode", "actual");
    if (done && !a.margin.empty()) done = set(wishes.options, "canvas.margin", a.margin);
    if (done && !a.place.empty()) done = set_place(wishes.options, a.place);
    if (done && !a.layers.empty())
        done = set(wishes.options, "drawing.layers", fmt::format("{}", fmt::join(a.layers, "; ")));
    if (done && !a.rules.empty())
        done = set(wishes.options, "drawing.rules", fmt::format("{}", fmt::join(a.rules, "; ")));
    if (done && !a.avoid.empty()) done = set(wishes.options, "avoid.finished", a.avoid);
    if (done && !a.occlusion.empty()) done = set(wishes.options, "drawing.occlusion", a.occlusion);
    if (done && a.invert) done = set(wishes.options, "ink.invert", "on");
    if (done && !a.dpi.empty()) done = set(wishes.options, "drawing.dpi", a.dpi);
    if (done && !a.border.empty()) done = set(wishes.options, "field.border", a.border);
    if (done && !a.keep_outs.empty())
        done = set(wishes.options, "field.keep_out", fmt::format("{}", fmt::join(a.keep_outs, "; ")));
    if (done && !a.park.empty()) done = set_pose(wishes.options, "park.", "--park", a.park);
    if (done && !a.exit.empty()) done = set_exit(wishes.options, a.exit);
    if (done && !a.start.empty()) done = set_drive_end(wishes.options, "start", a.start);
    if (done && !a.end.empty()) done = set_drive_end(wishes.options, "end", a.end);
    for (const std::string& text : a.settings)
        if (done) done = set_from_text(wishes, text);
    const auto add_edits = [&](const std::vector<std::string>& texts, auto parse) {
        for (const std::string& text : texts) {
            if (!done) return;
            const auto edit = parse(text);
            if (edit)
                wishes.edits.push_back(*edit);
            else
                done = tl::unexpected(edit.error());
        }
    };
    add_edits(a.links, parse_link);
    add_edits(a.entries, parse_entry);
    add_edits(a.directions, parse_direction);
    if (!done) return tl::unexpected(done.error());
    return wishes;
}

/// Twice: the canvas that is wished for decides the defaults of all that is not.
Outcome<Wishes> gathered(const PlanArguments& a) {
    auto first = gathered(a, Options{});
    if (!first) return first;
    return gathered(a, defaults_for({first->options.canvas.width, first->options.canvas.height}));
}

Outcome<Robot> robot_of(const Wishes& wishes) {
    auto robot = robot_named(wishes.robot.empty() ? "beachbot" : wishes.robot);
    for (const auto& [field, value] : wishes.robot_fields)
        if (robot) robot = with_field(*robot, field, value);
    return robot;
}

/// Stops the search when the user or the time limit says so.
Progress limited(Progress progress, double seconds) {
    if (seconds <= 0) return progress;
    const auto asked = progress.stopped;
    const auto used = [begin = std::clock(), seconds] {
        return static_cast<double>(std::clock() - begin) / (seconds * CLOCKS_PER_SEC);
    };
    progress.time_used = used;
    progress.stopped = [asked, used] { return asked() || used() >= 1; };
    return progress;
}

/// Opens a picture with the desktop's own viewer, without waiting for it to close. False: there is none.
bool open_picture(const std::string& path) {
    if (std::system("command -v xdg-open >/dev/null 2>&1") != 0) return false;
    const pid_t child = fork();
    if (child == 0) {
        if (fork() == 0) {
            execlp("xdg-open", "xdg-open", path.c_str(), static_cast<char*>(nullptr));
            _exit(127);
        }
        _exit(0);
    }
    if (child > 0) waitpid(child, nullptr, 0);
    return child > 0;
}

/// Where --open puts its picture: beside the plan.
std::string picture_path(const PlanArguments& arguments) {
    const fs::path base = arguments.output == "-" ? "strandline-plan.json" : arguments.output;
    return fs::path(base).replace_extension(".svg").string();
}

/// Either a file or --text.
Outcome<void> one_input(const PlanArguments& arguments) {
    const bool text = !arguments.lettering.text.empty();
    if (!text && arguments.input.empty())
        return fail("plan", "the drawing is missing", "name a file, or give words with --text");
    if (text && !arguments.input.empty())
        return fail("--text", "cannot be planned together with " + arguments.input, "give one of them");
    return {};
}

/// With `arguments.input` in the place of errors.
Outcome<svg::Document> read_drawing(const PlanArguments& arguments, const Options& options) {
    const auto bytes = read_input(arguments.input);
    if (!bytes) return tl::unexpected(bytes.error());
    return read_source({*bytes, arguments.input}, options);
}

/// No output may take the place of the drawing, or of another output.
Outcome<void> outputs_apart(const PlanArguments& arguments) {
    if (same_file(arguments.input, arguments.output))
        return fail("-o " + arguments.output, "is the drawing itself", "choose another name for the plan");
    if (!arguments.open) return {};
    const std::string picture = picture_path(arguments);
    if (same_file(arguments.input, picture))
        return fail("--open", "the picture " + picture + " would replace the drawing", "choose another -o");
    if (picture == arguments.output)
        return fail("--open", "the picture would replace the plan", "name the plan NAME.json");
    return {};
}

Outcome<void> show(const Plan& plan, const PlanArguments& arguments) {
    const std::string picture = picture_path(arguments);
    const auto written = write_output(picture, formats::write_svg(plan));
    if (written && !open_picture(picture))
        fmt::print(stderr, "the picture is {}; there is no desktop here to open it\n", picture);
    return written;
}

}  // namespace

int plan(const PlanArguments& arguments, const Common& common) {
    if (const auto one = one_input(arguments); !one) return complain(one.error(), bad_call);
    const auto wishes = gathered(arguments);
    if (!wishes) return complain(wishes.error(), bad_call);
    const auto robot = robot_of(*wishes);
    if (!robot) return complain(robot.error(), bad_call);
    if (const auto fits = valid(wishes->options, *robot); !fits) return complain(fits.error(), bad_call);
    if (const auto apart = outputs_apart(arguments); !apart) return complain(apart.error(), bad_call);
    const bool lettering = !arguments.lettering.text.empty();
    const Progress progress = limited(console_progress(common.quiet), wishes->options.tour.time_limit);
    const auto document =
        lettering ? lettered(arguments.lettering) : read_drawing(arguments, wishes->options);
    const std::string title = lettering                ? "text"
                              : arguments.input == "-" ? "stdin"
                                                       : fs::path(arguments.input).filename().string();
    // Files are named in front of the place in them.
    const auto refuse = [&](Error error) {
        if (error.place.empty() || error.place == title)
            error.place = lettering ? "text" : arguments.input;
        else if (!lettering && error.place != arguments.input)
            error.place = arguments.input + ", " + error.place;
        return complain(error, fault_of(error));
    };
    if (!document) return refuse(document.error());
    auto made = make_plan(*document, title, *robot, wishes->options, wishes->edits, progress);
    if (!made) return refuse(made.error());
    made->program = "strandline " STRANDLINE_VERSION;
    // A long plan takes as long to prove as to write: both only read it, so they go side by side. Where
    // nobody asks for the report, it is never made.
    const bool proof_wanted = !common.quiet || arguments.strict;
    std::future<check::Report> proof = std::async(proof_wanted ? std::launch::async : std::launch::deferred,
                                                  [&made] { return check::prove(*made); });
    if (const auto done = write_output(arguments.output, formats::write_plan(*made)); !done)
        return complain(done.error(), bad_input);

    warn(made->warnings, common.quiet);
    for (const std::string& idle : made->idle_edits)
        if (!common.quiet) fmt::print(stderr, "warning: {}\n", idle);
    const check::Report report = proof_wanted ? proof.get() : check::Report{};
    if (common.json)
        fmt::print(arguments.output == "-" ? stderr : stdout, "{}\n", formats::write_figures(*made));
    else if (!common.quiet)
        fmt::print(stderr, "{}", summary(*made, report));
    if (!common.quiet) fmt::print(stderr, "{}", findings(report, common.verbose));
    if (!common.quiet && common.verbose) fmt::print(stderr, "{}", places(*made, report));
    const std::string short_of = arguments.strict ? shortcomings(*made, report) : "";
    fmt::print(stderr, "{}", short_of);
    if (arguments.open)
        if (const auto shown = show(*made, arguments); !shown) return complain(shown.error(), bad_input);
    return short_of.empty() ? done : falls_short;
}

}  // namespace strandline::cli
