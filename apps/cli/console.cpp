#include "console.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
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

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Outcome<std::string> read_input(const std::string& path) {
    if (path == "-") return std::string(std::istreambuf_iterator<char>(std::cin), {});
    std::error_code code;
    if (std::filesystem::is_directory(path, code)) return fail(path, "is a folder", "name a file");
    std::ifstream file(path, std::ios::binary);
    if (!file) return fail(path, std::string("cannot be read: ") + std::strerror(errno), "check the name");
    std::string bytes;
    std::array<char, 1U << 16U> part;
    while (file.read(part.data(), part.size()), file.gcount() > 0)
        bytes.append(part.data(), static_cast<std::size_t>(file.gcount()));
    if (file.bad()) return fail(path, "reading stopped half-way");
    return bytes;
}

namespace {

/// A file written whole under a temporary name, waiting to be put in its place.
struct Staged {
    std::string temporary, place;
};

tl::unexpected<Error> failure(const std::string& path, const std::string& what) {
    return fail(path, what + ": " + std::strerror(errno), "check the folder, its rights and the space left");
}

Outcome<void> write_stream(const std::string& to, const std::string& named, std::string_view bytes) {
    errno = 0;
    std::ofstream file(to, std::ios::binary | std::ios::trunc);
    if (!file) return failure(named, "cannot be written");
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) return failure(named, "could not be written whole");
    return {};
}

/// Nothing to rename where the target is a device or a pipe: `temporary` is then empty.
Outcome<Staged> staged(const std::string& path, std::string_view bytes) {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (fs::is_directory(status)) return fail(path, "is a folder", "name a file");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        if (const auto done = write_stream(path, path, bytes); !done) return tl::unexpected(done.error());
        return Staged{};
    }
    const std::string place = fs::exists(status) ? fs::canonical(path, code).string() : path;
    // Apart from other programs and from other threads that write the same name.
    static std::atomic<unsigned> written = 0;
    Staged file{fmt::format("{}.part{}-{}", place, getpid(), ++written), place};
    if (const auto done = write_stream(file.temporary, path, bytes); !done) {
        std::remove(file.temporary.c_str());
        return tl::unexpected(done.error());
    }
    if (fs::exists(status)) fs::permissions(file.temporary, status.permissions(), code);
    return file;
}

}  // namespace

Outcome<void> write_outputs(const std::vector<std::pair<std::string, std::string_view>>& files) {
    // A file size limit shall be an error of writing, not the end of the program.
    std::signal(SIGXFSZ, SIG_IGN);
    std::vector<Staged> ready;
    const auto give_up = [&](const Error& error) -> Outcome<void> {
        for (const Staged& file : ready)
            if (!file.temporary.empty()) std::remove(file.temporary.c_str());
        return tl::unexpected(error);
    };
    for (const auto& [path, bytes] : files) {
        auto file = staged(path, bytes);
        if (!file) return give_up(file.error());
        ready.push_back(*file);
    }
    for (const Staged& file : ready)
        if (!file.temporary.empty() && std::rename(file.temporary.c_str(), file.place.c_str()) != 0)
            return give_up(failure(file.place, "cannot be put in place").value());
    return {};
}

Outcome<void> write_output(const std::string& path, std::string_view bytes) {
    if (path != "-") return write_outputs({{path, bytes}});
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    if (!std::cout) return fail("stdout", "cannot be written");
    return {};
}

bool same_file(const std::string& a, const std::string& b) {
    std::error_code code;
    return std::filesystem::equivalent(a, b, code);
}

int complain(const Error& error, Exit exit) {
    fmt::print(stderr, "strandline: {}\n", sentence(error));
    return exit;
}

void warn(const Warnings& warnings, bool quiet) {
    if (quiet) return;
    for (const Warning& warning : warnings) fmt::print(stderr, "warning: {}\n", sentence(warning));
}

void show_bar(const std::string& what, double share) {
    if (!isatty(STDERR_FILENO)) return;
    const int percent = static_cast<int>(100 * share), bars = percent / 5;
    if (share >= 1)
        fmt::print(stderr, "\r\033[K");
    else
        fmt::print(stderr, "\r\033[K{:<12} [{:#<{}}{:.<{}}] {:3}%", what, "", bars, "", 20 - bars, percent);
}

Progress console_progress(bool quiet) {
    std::signal(SIGINT, on_interrupt);
    Progress progress;
    progress.stopped = [] { return interrupted != 0; };
    if (!quiet)
        progress.report = [shown = -1](const std::string& what, double share) mutable {
            const int percent = static_cast<int>(100 * share);
            if (percent == shown) return;
            shown = percent;
            show_bar(what, share);
        };
    return progress;
}

Progress limited(Progress progress, double seconds, int threads) {
    if (seconds <= 0) return progress;
    clockid_t clock = CLOCK_PROCESS_CPUTIME_ID;
    if (threads <= 1) pthread_getcpuclockid(pthread_self(), &clock);
    const auto asked = progress.stopped;
    const auto used = [clock, begin = seconds_of(clock), seconds] {
        return (seconds_of(clock) - begin) / seconds;
    };
    progress.time_used = used;
    progress.stopped = [asked, used] { return asked() || used() >= 1; };
    return progress;
}

}  // namespace strandline::cli
