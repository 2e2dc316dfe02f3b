#pragma once
// Runs the built program as a user would.
#include <sys/wait.h>

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

}  // namespace strandline::test
