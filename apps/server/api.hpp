#pragma once
// The editor's API, version 1 (web/public/openapi.json): a call in, a reply out. Knows nothing of sockets.
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "folder.hpp"
#include "input/svg/svg.hpp"
#include "workspace.hpp"

namespace strandline::serve {

struct Exported {
    std::string bytes;
    Warnings warnings;
};
/// A form in which a plan can be taken away.
struct Exporter {
    std::string name, what;
    std::string suffix;  ///< behind the project's id: "_robot.txt"
    std::string type;    ///< "text/plain"
    std::function<Outcome<Exported>(const Plan&)> write;
};
struct Lettering {
    std::string text, font = "rowmans", align = "left";
    double height = 1;  ///< metres
};
struct FontName {
    std::string name, what;
};
/// What the program around the server knows and does for it.
struct Setup {
    std::string program;  ///< "strandline 0.1.0"
    std::vector<Exporter> exporters;
    std::vector<FontName> fonts;
    std::function<Outcome<svg::Document>(const Lettering&)> letter;
};

struct Call {
    std::string method, path;
    std::map<std::string, std::string> query,
        headers;  ///< headers: only those that the API looks at, lower case
    std::string_view body;
};
struct Reply {
    int status = 200;
    std::string type = json_type, body = {};
    std::map<std::string, std::string> headers = {};
};
/// {"error": {"code", "place", "reason", "remedy"}}.
Reply refusal(int status, const Error& error);

/// No JSON of an edit is larger; drawings may be.
inline constexpr std::size_t largest_json = 8u << 20, largest_upload = 64u << 20;

class Api {
  public:
    Api(Setup setup, Folder folder);
    Reply answer(const Call& call);
    /// Opened when it is not. Error: no such project, a file that is none.
    Outcome<std::shared_ptr<Workspace>> workspace(const std::string& id);
    /// A new project from a drawing, a picture, a project file, or nothing. Gives its id. Error: what cannot
    /// be read, or draws nothing; no project is made of it.
    Outcome<std::string> create(const std::string& title, std::string bytes);
    /// For good. Error: no such project, no right to.
    Outcome<void> remove(const std::string& id);
    const Folder& folder() const { return folder_; }
    /// Ends every event stream.
    void close();

  private:
    Reply answer_about() const;
    Reply answer_projects(const Call& call);
    Reply answer_removal(const std::string& id);
    Reply answer_project(const Call& call, Workspace& workspace, const std::string& what);
    Reply answer_lettering(const Call& call) const;

    const Setup setup_;
    const Folder folder_;
    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<Workspace>> open_;
};

}  // namespace strandline::serve
