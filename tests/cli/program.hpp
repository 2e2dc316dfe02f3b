#pragma once
// Runs the built program as a user would.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace strandline::test {

namespace fs = std::filesystem;

struct Result {
    int exit = -1;
    std::string out, err;
};

inline std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}
inline void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// A folder of its own for each test process, gone afterwards.
class Folder {
  public:
    Folder() {
        std::string shape = (fs::temp_directory_path() / "strandline-XXXXXX").string();
        path_ = mkdtemp(shape.data());
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    fs::path operator/(const std::string& name) const { return path_ / name; }
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// `arguments` as a shell reads them; the program runs in `folder`.
inline Result run(const Folder& folder, const std::string& arguments) {
    const fs::path out = folder / ".out", err = folder / ".err";
    const std::string command = "cd '" + folder.path().string() + "' && '" STRANDLINE_PROGRAM "' " +
                                arguments + " >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
}

/// A drawing whose search ends only when it is stopped, where tour.moves is large.
inline void write_endless(const fs::path& path) {
    std::string many = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 1000'>";
    for (int k = 0; k < 300; ++k)
        many += "<path d='M" + std::to_string(k * 37 % 1000) + " " + std::to_string(k * 91 % 1000) +
                "l20 20' stroke='black'/>";
    write(path, many + "</svg>");
}

/// As run(), but with Ctrl-C as soon as `wait` is over: shell commands that may look at what was "said" on
/// stderr.
inline Result interrupted(const Folder& folder, const std::string& arguments, const std::string& wait) {
    write(folder / "go.sh", "'" STRANDLINE_PROGRAM "' " + arguments + " >out 2>said & program=$!\n" + wait +
                                "\nkill -INT $program; wait $program; echo $? >code\n");
    // A shell without job control would start it deaf to interrupts.
    const std::string shell = "cd '" + folder.path().string() + "' && bash -m go.sh 2>/dev/null";
    if (std::system(shell.c_str()) != 0) return {};
    return {std::atoi(read(folder / "code").c_str()), read(folder / "out"), read(folder / "said")};
}

/// The call ends with `code` and one line that holds `words`, and writes no file "out".
inline void expect_refused(const Folder& folder, const std::string& arguments, int code,
                           const std::string& words) {
    const Result result = run(folder, arguments);
    EXPECT_EQ(result.exit, code) << arguments << "\n" << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(folder / "out")) << arguments;
}

}  // namespace strandline::test
