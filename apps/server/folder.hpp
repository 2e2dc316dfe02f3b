#pragma once
// The project folder: the only place on the disk that the server reads projects from and writes them to.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"

namespace strandline::serve {

/// A project's id is its file's name without ".strandline": letters, digits, "-" and "_", at most 64.
bool is_project_id(std::string_view id);
/// "My drawing.svg" -> "My-drawing"; never empty.
std::string project_id_for(const std::string& title);

class Folder {
  public:
    explicit Folder(std::filesystem::path path) : path_(std::move(path)) {}
    const std::filesystem::path& path() const { return path_; }
    /// Ids, sorted.
    std::vector<std::string> projects() const;
    bool holds(const std::string& id) const;
    /// An id that no project has: `wanted`, or with "-2", "-3" ... behind it.
    std::string unused(const std::string& wanted) const;
    /// Error: no such id, a link to elsewhere, unreadable.
    Outcome<std::string> read(const std::string& id) const;
    /// Written beside it, brought to the disk, then renamed: whenever the program is ended there is the old
    /// file or the new one.
    Outcome<void> write(const std::string& id, std::string_view text) const;
    /// Error: no such id, no right to.
    Outcome<void> remove(const std::string& id) const;

  private:
    std::filesystem::path file_of(const std::string& id) const;
    std::filesystem::path path_;
};

}  // namespace strandline::serve
