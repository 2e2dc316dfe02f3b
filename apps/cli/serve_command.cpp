// strandline serve: what the editor's server is given of this machine.
#ifdef STRANDLINE_EDITOR
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>

#include "commands.hpp"
#include "console.hpp"
#include "export_formats.hpp"
#include "fonts.hpp"
#include "result/formats/formats.hpp"
#include "server/server.hpp"

namespace strandline::cli {
namespace {

namespace fs = std::filesystem;

/// A format of several files is offered file by file: "beachbot-robot" is the one that ends in _robot.txt.
std::string name_of(const exports::Format& format, std::size_t file) {
    if (format.suffixes.size() == 1) return format.name;
    const std::string& suffix = format.suffixes[file];
    return format.name + "-" + suffix.substr(1, suffix.rfind('.') - 1);
}

std::vector<serve::Exporter> exporters() {
    std::vector<serve::Exporter> list{{"plan", "the plan itself: check, render and export read it",
                                       "_plan.json", "application/json", [](const Plan& plan) {
                                           return serve::Exported{formats::write_plan(plan), {}};
                                       }}};
    for (const exports::Format& format : export_formats())
        for (std::size_t file = 0; file < format.suffixes.size(); ++file)
            list.push_back({name_of(format, file), format.what, format.suffixes[file], format.type,
                            [write = format.write, file](const Plan& plan) -> Outcome<serve::Exported> {
                                auto written = write(plan, {});
                                if (!written) return tl::unexpected(written.error());
                                return serve::Exported{std::move(written->files[file].bytes),
                                                       std::move(written->warnings)};
                            }});
    return list;
}

/// Only installed fonts: a name from outside must not open files.
Outcome<svg::Document> letter(const serve::Lettering& wanted) {
    const auto fonts = installed_fonts();
    if (!fonts) return tl::unexpected(fonts.error());
    if (std::ranges::find(*fonts, wanted.font, &FontEntry::name) == fonts->end())
        return fail("font", "\"" + wanted.font + "\" is not installed", "use one of GET /api/v1/about");
    const auto font = font_named(wanted.font);
    if (!font) return tl::unexpected(font.error());
    lettering::Options options;
    options.height = wanted.height;
    options.align = wanted.align == "right"    ? lettering::Align::right
                    : wanted.align == "centre" ? lettering::Align::centre
                                               : lettering::Align::left;
    return lettering::lettered(wanted.text, *font, options);
}

serve::Setup setup() {
    serve::Setup setup{"strandline " STRANDLINE_VERSION, exporters(), {}, letter};
    if (const auto fonts = installed_fonts())
        for (const FontEntry& font : *fonts) setup.fonts.push_back({font.name, font.what});
    return setup;
}

fs::path folder_of(const ServeArguments& arguments) {
    if (!arguments.folder.empty()) return arguments.folder;
    if (arguments.input.empty()) return fs::current_path();
    return fs::absolute(arguments.input).parent_path();
}

/// The editor's pages: beside the program where it is installed, else where they are built.
std::string pages() {
    std::error_code code;
    const fs::path installed =
        fs::read_symlink("/proc/self/exe", code).parent_path() / STRANDLINE_INSTALLED_WEB;
    return fs::exists(installed / "index.html", code) ? installed.lexically_normal().string()
                                                      : STRANDLINE_WEB;
}

/// The project to show first: the one that is named, the one that was begun from this drawing, or a new one.
Outcome<std::string> first_project(serve::Api& api, const ServeArguments& arguments) {
    if (arguments.input.empty()) {
        const auto there = api.folder().projects();
        return there.empty() ? api.create("sketch", "") : Outcome<std::string>(there.front());
    }
    const fs::path input = fs::absolute(arguments.input);
    std::error_code code;
    if (input.extension() == ".strandline" &&
        fs::equivalent(input.parent_path(), api.folder().path(), code)) {
        const auto opened = api.workspace(input.stem().string());
        if (!opened) return tl::unexpected(opened.error());
        return (*opened)->id();
    }
    auto bytes = read_input(arguments.input);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string title = input.filename().string();
    for (const std::string& id : api.folder().projects()) {
        if (!id.starts_with(serve::project_id_for(title))) continue;
        const auto opened = api.workspace(id);
        if (opened && (*opened)->began_with({title, *bytes})) return id;
    }
    return api.create(title, std::move(*bytes));
}

}  // namespace

int serve(const ServeArguments& arguments, const Common& common) {
    const fs::path folder = folder_of(arguments);
    std::error_code code;
    if (!fs::is_directory(folder, code))
        return complain({folder.string(), "is no folder", "name one with --folder"}, bad_call);
    // Before any thread begins: they inherit what is blocked, so that one thread alone hears of it.
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    signal(SIGPIPE, SIG_IGN);  // a page that is closed while it is written to

    serve::Api api(setup(), serve::Folder(folder));
    const auto first = first_project(api, arguments);
    if (!first) return complain(first.error(), bad_input);
    const std::string web = arguments.web.empty() ? pages() : arguments.web;
    const bool built = fs::exists(fs::path(web) / "index.html", code);
    if (!built) fmt::print(stderr, "note: the editor's pages are not built ({}); ./run builds them\n", web);
    const auto listening = [&](int port) {
        // What listens everywhere is here by this name; others use the machine's address.
        const bool here = arguments.host == "127.0.0.1" || arguments.host == "0.0.0.0";
        const std::string host = here ? "localhost" : arguments.host;
        const std::string token = arguments.token.empty() ? "" : "&token=" + arguments.token;
        fmt::print(common.json ? stderr : stdout, "http://{}:{}/?project={}{}\n", host, port, *first, token);
        if (common.json) fmt::print("{{\"port\":{},\"project\":\"{}\"}}\n", port, *first);
        std::fflush(stdout);
        if (arguments.host == "0.0.0.0" && !common.quiet)
            fmt::print(stderr, "from other machines: http://THIS-MACHINE'S-ADDRESS:{}/?token={}\n", port,
                       arguments.token);
    };
    const auto ended = [&] {
        int which = 0;
        sigwait(&signals, &which);
    };
    const auto served = serve::serve(api, {arguments.host, arguments.port, arguments.token, built ? web : ""},
                                     listening, ended);
    if (!served) return complain(served.error(), bad_call);
    return done;
}

}  // namespace strandline::cli
#endif
