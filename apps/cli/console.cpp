#include "console.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace strandline::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int) {
    if (interrupted) std::_Exit(130);
    interrupted = 1;
}

}  // namespace

Outcome<std::string> read_input(const std::string& path) {
    if (path == "-") return std::string(std::istreambuf_iterator<char>(std::cin), {});
    std::error_code code;
    if (std::filesystem::is_directory(path, code)) return fail(path, "is a folder", "name a file");
    std::ifstream file(path, std::ios::binary);
    if (!file) return fail(path, std::string("cannot be read: ") + std::strerror(errno), "check the name");
    std::string bytes(std::istreambuf_iterator<char>(file), {});
    if (file.bad()) return fail(path, "reading stopped half-way");
    return bytes;
}

Outcome<void> write_output(const std::string& path, std::string_view bytes) {
    if (path == "-") {
        std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
        if (!std::cout) return fail("stdout", "cannot be written");
        return {};
    }
    const std::string temporary = path + ".part" + std::to_string(getpid());
    const auto give_up = [&](const char* why) {
        const std::string reason = std::string(why) + ": " + std::strerror(errno);
        std::remove(temporary.c_str());
        return fail(path, reason, "check the folder, its rights and the space left");
    };
    errno = 0;
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    if (!file) return give_up("cannot be written");
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) return give_up("could not be written whole");
    if (std::rename(temporary.c_str(), path.c_str()) != 0) return give_up("cannot be put in place");
    return {};
}

void complain(const Error& error) { fmt::print(stderr, "strandline: {}\n", sentence(error)); }

void warn(const Warnings& warnings, bool quiet) {
    if (quiet) return;
    for (const Warning& warning : warnings) fmt::print(stderr, "warning: {}\n", sentence(warning));
}

Progress console_progress(bool quiet) {
    std::signal(SIGINT, on_interrupt);
    Progress progress;
    progress.stopped = [] { return interrupted != 0; };
    if (!quiet && isatty(STDERR_FILENO)) {
        progress.report = [shown = -1](const std::string& what, double share) mutable {
            const int percent = static_cast<int>(100 * share);
            if (percent == shown) return;
            shown = percent;
            const int bars = percent / 5;
            fmt::print(stderr, "\r\033[K{:<12} [{:#<{}}{:.<{}}] {:3}%", what, "", bars, "", 20 - bars,
                       percent);
            if (share >= 1) fmt::print(stderr, "\r\033[K");
        };
    }
    return progress;
}

}  // namespace strandline::cli
