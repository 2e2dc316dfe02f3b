#include "folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

namespace strandline::serve {
namespace {

namespace fs = std::filesystem;
constexpr const char* extension = ".strandline";
constexpr std::size_t longest_id = 64;

bool is_id_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_'; }

/// Closes itself.
class File {
  public:
    File(const fs::path& path, int flags) : handle_(open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
        if (handle_ >= 0) close(handle_);
    }
    explicit operator bool() const { return handle_ >= 0; }
    int handle() const { return handle_; }

  private:
    int handle_;
};

bool write_all(int handle, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(handle, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

}  // namespace

bool is_project_id(std::string_view id) {
    return !id.empty() && id.size() <= longest_id && std::ranges::all_of(id, is_id_letter);
}

std::string project_id_for(const std::string& title) {
    const std::string name = title.substr(title.find_last_of("/\\") + 1);  // npos + 1 is 0
    const std::size_t dot = name.rfind('.');
    const std::string stem = dot == 0 ? name : name.substr(0, dot);
    std::string id;
    for (const char c : stem)
        if (is_id_letter(c))
            id += c;
        else if (!id.empty() && id.back() != '-')
            id += '-';
    while (!id.empty() && id.back() == '-') id.pop_back();
    constexpr std::size_t room_for_a_number = 8;
    return id.empty() ? "drawing" : id.substr(0, longest_id - room_for_a_number);
}

fs::path Folder::file_of(const std::string& id) const { return path_ / (id + extension); }

std::vector<std::string> Folder::projects() const {
    std::vector<std::string> ids;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(path_, none)) {
        const std::string id = entry.path().stem().string();
        if (entry.path().extension() == extension && is_project_id(id) && holds(id)) ids.push_back(id);
    }
    std::ranges::sort(ids);
    return ids;
}

bool Folder::holds(const std::string& id) const {
    std::error_code none;
    return is_project_id(id) && fs::symlink_status(file_of(id), none).type() == fs::file_type::regular;
}

std::string Folder::unused(const std::string& wanted) const {
    std::error_code none;
    std::string id = wanted;
    for (int number = 2; fs::exists(fs::symlink_status(file_of(id), none)); ++number)
        id = wanted + "-" + std::to_string(number);
    return id;
}

Outcome<std::string> Folder::read(const std::string& id) const {
    if (!holds(id)) return fail(id, "there is no such project", "list them with GET /api/v1/projects");
    const File file(file_of(id), O_RDONLY | O_NOFOLLOW);
    struct stat status {};
    if (!file || fstat(file.handle(), &status) != 0 || !S_ISREG(status.st_mode))
        return fail(id, std::string("the project file cannot be read: ") + std::strerror(errno));
    std::string text(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t have = 0;
    while (have < text.size()) {
        const ssize_t got = ::read(file.handle(), text.data() + have, text.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return fail(id, "the project file ends early", "open it again");
        have += static_cast<std::size_t>(got);
    }
    return text;
}

Outcome<void> Folder::write(const std::string& id, std::string_view text) const {
    const fs::path target = file_of(id), fresh = path_ / ("." + id + extension + ".tmp");
    const auto failed = [&](const char* what) {
        const std::string why = std::strerror(errno);
        unlink(fresh.c_str());
        return fail(target.string(), std::string(what) + ": " + why, "check the disk's space and rights");
    };
    {
        const File file(fresh, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
        if (!file) return failed("the project cannot be saved");
        if (!write_all(file.handle(), text) || fsync(file.handle()) != 0)
            return failed("the project cannot be saved");
    }
    if (std::rename(fresh.c_str(), target.c_str()) != 0) return failed("the project cannot be put in place");
    return {};
}

Outcome<void> Folder::remove(const std::string& id) const {
    if (!holds(id)) return fail(id, "there is no such project", "list them with GET /api/v1/projects");
    if (unlink(file_of(id).c_str()) != 0)
        return fail(file_of(id).string(),
                    std::string("the project cannot be deleted: ") + std::strerror(errno),
                    "check the folder's rights");
    return {};
}

}  // namespace strandline::serve
