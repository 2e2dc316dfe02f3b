#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <future>

#include "commands.hpp"
#include "console.hpp"
#include "fonts.hpp"
#include "part_plans.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "planning.hpp"
#include "result/check/check.hpp"
#include "result/formats/formats.hpp"
#include "summary.hpp"

namespace strandline::cli {
namespace {

namespace fs = std::filesystem;

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
    const auto asked = asked_of(arguments);
    if (!asked) return complain(asked.error(), bad_call);
    if (const auto apart = outputs_apart(arguments); !apart) return complain(apart.error(), bad_call);
    const Wishes& wishes = asked->wishes;
    const bool lettering = !arguments.lettering.text.empty();
    const Progress progress = console_progress(common.quiet);
    const auto document = lettering ? lettered(arguments.lettering) : read_drawing(arguments, wishes.options);
    const std::string title = lettering                ? "text"
                              : arguments.input == "-" ? "stdin"
                                                       : fs::path(arguments.input).filename().string();
    const auto refuse = [&](Error error) {
        if (!lettering) error = in_file(std::move(error), title, arguments.input);
        if (error.place.empty()) error.place = title;
        return complain(error, fault_of(error));
    };
    if (!document) return refuse(document.error());
    parts::Limit limit;
    if (!arguments.split.empty()) {
        const auto read = read_limit(arguments.split, "--split");
        if (!read) return complain(read.error(), bad_call);
        if (arguments.output == "-")
            return complain({"--split", "writes several files", "name them with -o NAME.json"}, bad_call);
        limit = *read;
    }
    const auto made = planned(*document, title, *asked, progress);
    if (!made) return refuse(made.error());
    // A long plan takes as long to prove as to write: both only read it, so they go side by side. Where
    // nobody asks for the report, it is never made.
    const bool proof_wanted = !common.quiet || arguments.strict;
    std::future<check::Report> proof = std::async(proof_wanted ? std::launch::async : std::launch::deferred,
                                                  [&made] { return check::prove(*made); });
    if (const auto done = write_output(arguments.output, formats::write_plan(*made)); !done)
        return complain(done.error(), bad_input);
    if (!arguments.split.empty())
        if (const auto done = write_parts(*made, limit, arguments.output, common.quiet); !done)
            return complain(done.error(), bad_input);

    warn(made->warnings, common.quiet);
    for (const std::string& idle : made->idle_edits)
        if (!common.quiet) fmt::print(stderr, "warning: {}\n", idle);
    const check::Report report = proof_wanted ? proof.get() : check::Report{};
    if (common.json)
        fmt::print(arguments.output == "-" ? stderr : stdout, "{}\n", formats::write_figures(*made));
    else if (!common.quiet)
        fmt::print(
            stderr, "{}{}{}", summary(*made, report),
            fidelity_rows(fidelity::judged(made->drawing, fidelity::drive_of(*made)).report),
            legibility_rows(made->drawing, legibility::report(made->drawing, made->robot), common.verbose));
    if (!common.quiet) fmt::print(stderr, "{}", findings(report, common.verbose));
    if (!common.quiet) fmt::print(stderr, "{}", places(*made, report, common.verbose));
    const std::string short_of = arguments.strict ? shortcomings(*made, report) : "";
    fmt::print(stderr, "{}", short_of);
    if (arguments.open)
        if (const auto shown = show(*made, arguments); !shown) return complain(shown.error(), bad_input);
    return short_of.empty() ? done : falls_short;
}

}  // namespace strandline::cli
