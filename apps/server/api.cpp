#include "api.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "answers.hpp"
#include "leading.hpp"
#include "project_text.hpp"

namespace strandline::serve {
namespace {

constexpr std::string_view root = "/api/v1/";
// Each has two threads and the memory of a plan.
constexpr std::size_t most_open = 64;

Reply not_found(const std::string& path) {
    return refusal(404, {path, "there is nothing here", "see /openapi.json"});
}
Reply not_allowed(const std::string& method) {
    return refusal(405, {method, "cannot be done here", "see /openapi.json"});
}

/// The status that tells a client what to do about an Error of Workspace::change.
int status_of(const Error& error) {
    if (error.place == "revision") return 409;
    if (error.place == "project") return 404;
    return error.reason.find("cannot be saved") != std::string::npos ? 507 : 422;
}

Reply changed(const Outcome<long long>& revision) {
    if (!revision) return refusal(status_of(revision.error()), revision.error());
    return json_reply(200, fmt::format("{{\"revision\":{}}}", *revision));
}

std::string etag_of(const std::string& tag) { return "\"" + tag + "\""; }

/// "As you have it", where the call says that it has this.
std::optional<Reply> known_reply(const std::string& tag, const std::string& type, const Call& call) {
    const auto known = call.headers.find("if-none-match");
    if (known == call.headers.end() || known->second != etag_of(tag)) return std::nullopt;
    return Reply{304, type, "", {{"ETag", etag_of(tag)}, {"Cache-Control", "no-cache"}}};
}

/// A part of the plan, or nothing but "as you have it".
Reply part_reply(const Part& part, const Call& call) {
    if (part.tag.empty()) return refusal(404, {"report", "is not made yet", "wait for the next event"});
    if (auto known = known_reply(part.tag, part.type, call)) return *std::move(known);
    return {200, part.type, part.bytes, {{"ETag", etag_of(part.tag)}, {"Cache-Control", "no-cache"}}};
}

/// All samples, or what makes them of those that the page has ("since": their tag), where they are known
/// still.
Reply samples_reply(const Planned& planned, const Call& call) {
    constexpr const char* type = "application/octet-stream";
    const SampleRow& row = *planned.samples;
    if (auto known = known_reply(row.tag, type, call)) return *std::move(known);
    const std::string since = value_in(call.query, "since", "");
    const SampleRow* base = row.tag == since ? &row : nullptr;
    for (const auto& before : planned.before)
        if (base == nullptr && before->tag == since) base = before.get();
    // What makes it of another is good for one page, once.
    return {200,
            type,
            splice_text(row, base),
            {{"ETag", etag_of(row.tag)}, {"Cache-Control", base ? "no-store" : "no-cache"}}};
}

Reply edit(Workspace& workspace, const Call& call) {
    if (call.body.size() > largest_json)
        return refusal(413, {"body", "is larger than 8 MB", "send fewer changes at once"});
    auto asked = read_asked(call.body, "body");
    if (!asked) return refusal(400, asked.error());
    return changed(workspace.change(
        asked->revision, [&](Project& project) { return take_step(project, std::move(asked->step)); }));
}

Reply lead(const Workspace& workspace, const Call& call) {
    if (call.body.size() > largest_json)
        return refusal(413, {"body", "is larger than 8 MB", "send fewer poses"});
    return leading_reply(workspace, call.body);
}

Reply move_along(Workspace& workspace, const Call& call, Outcome<void> (*move)(Project&)) {
    const auto revision = revision_in(call.body);
    if (!revision) return refusal(400, revision.error());
    return changed(workspace.change(*revision, move));
}

Reply take_source(Workspace& workspace, const Call& call) {
    const auto revision = revision_in_query(call);
    if (!revision) return refusal(400, revision.error());
    SourceFile source{value_in(call.query, "title", "drawing"), std::string(call.body)};
    if (const auto fine = is_drawing(source); !fine) return refusal(415, fine.error());
    return changed(workspace.change(*revision, [&](Project& project) {
        project.sources.push_back(std::make_shared<const SourceFile>(source));
        const int number = static_cast<int>(project.sources.size()) - 1;
        return take_step(project, {"open " + source.title, {SourceChange{number}}});
    }));
}

}  // namespace

Api::Api(Setup setup, Folder folder) : setup_(std::move(setup)), folder_(std::move(folder)) {}

Outcome<std::shared_ptr<Workspace>> Api::workspace(const std::string& id) {
    const std::lock_guard lock(mutex_);
    if (const auto found = open_.find(id); found != open_.end()) return found->second;
    const auto text = folder_.read(id);
    if (!text) return tl::unexpected(text.error());
    auto project = read_project(*text, id);
    if (!project) return tl::unexpected(project.error());
    if (open_.size() >= most_open)  // one that nobody looks at makes room
        std::erase_if(open_, [gone = false](const auto& entry) mutable {
            const bool idle = !gone && entry.second.use_count() == 1 && entry.second->hub().listeners() == 0;
            gone = gone || idle;
            return idle;
        });
    if (open_.size() >= most_open)
        return fail(id, fmt::format("{} projects are open", most_open), "close some of the editor's pages");
    auto opened = std::make_shared<Workspace>(id, std::move(*project), folder_, setup_.program);
    open_[id] = opened;
    return opened;
}

Outcome<std::string> Api::create(const std::string& title, std::string bytes) {
    Project project;
    if (is_project_text(bytes)) {
        auto read = read_project(bytes, title);
        if (!read) return tl::unexpected(read.error());
        project = std::move(*read);
    } else {
        SourceFile file{title, std::move(bytes)};
        if (!file.bytes.empty())
            if (const auto fine = is_drawing(file); !fine) return tl::unexpected(fine.error());
        project.title = title;
        project.sources.push_back(std::make_shared<const SourceFile>(std::move(file)));
    }
    const std::lock_guard lock(mutex_);
    const std::string id = folder_.unused(project_id_for(title));
    if (const auto saved = folder_.write(id, write_project(project)); !saved)
        return tl::unexpected(saved.error());
    return id;
}

Outcome<void> Api::remove(const std::string& id) {
    std::shared_ptr<Workspace> opened;  // ended behind the lock: its threads take a moment
    const std::lock_guard lock(mutex_);
    const auto found = open_.find(id);
    if (found == open_.end()) return folder_.remove(id);
    opened = found->second;
    auto gone = opened->remove();
    if (gone) open_.erase(found);
    return gone;
}

void Api::close() {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, workspace] : open_) workspace->hub().close();
}

Reply Api::answer(const Call& call) {
    if (!call.path.starts_with(root)) return not_found(call.path);
    const std::vector<std::string> parts = path_parts(call.path.substr(root.size()));
    const std::string& first = parts.front();
    if (first == "about" && parts.size() == 1)
        return call.method == "GET" ? answer_about() : not_allowed(call.method);
    if (first == "lettering" && parts.size() == 1)
        return call.method == "POST" ? answer_lettering(call) : not_allowed(call.method);
    if (first != "projects") return not_found(call.path);
    if (parts.size() == 1) return answer_projects(call);
    if (call.method == "DELETE" && parts.size() == 2) return answer_removal(parts[1]);
    const auto found = workspace(parts[1]);
    if (!found) return refusal(folder_.holds(parts[1]) ? 500 : 404, found.error());
    std::string rest;
    for (std::size_t i = 2; i < parts.size(); ++i) rest += (rest.empty() ? "" : "/") + parts[i];
    return answer_project(call, **found, rest);
}

Reply Api::answer_about() const { return json_reply(200, about_text(setup_)); }

Reply Api::answer_projects(const Call& call) {
    if (call.method == "GET") return json_reply(200, list_text(folder_.projects()));
    if (call.method != "POST") return not_allowed(call.method);
    const auto id = create(value_in(call.query, "title", "drawing"), std::string(call.body));
    if (!id) return refusal(status_of(id.error()) == 507 ? 507 : 415, id.error());
    return json_reply(201, id_text(*id));
}

Reply Api::answer_removal(const std::string& id) {
    if (const auto gone = remove(id); !gone) return refusal(folder_.holds(id) ? 500 : 404, gone.error());
    return json_reply(200, id_text(id));
}

Reply Api::answer_project(const Call& call, Workspace& workspace, const std::string& what) {
    const bool get = call.method == "GET", post = call.method == "POST";
    if (what.empty()) return get ? json_reply(200, standing_text(workspace)) : not_allowed(call.method);
    if (what == "file")
        return get ? Reply{200,
                           json_type,
                           workspace.file_text(),
                           {{"Content-Disposition",
                             fmt::format("attachment; filename=\"{}.strandline\"", workspace.id())}}}
                   : not_allowed(call.method);
    if (what == "edits") return post ? edit(workspace, call) : not_allowed(call.method);
    if (what == "undo") return post ? move_along(workspace, call, undo) : not_allowed(call.method);
    if (what == "redo") return post ? move_along(workspace, call, redo) : not_allowed(call.method);
    if (what == "connection") return post ? lead(workspace, call) : not_allowed(call.method);
    if (what == "source") return post ? take_source(workspace, call) : not_allowed(call.method);

    const std::size_t slash = what.find('/');
    const std::string kind = what.substr(0, slash),
                      name = slash == std::string::npos ? "" : what.substr(slash + 1);
    if (kind != "plan" && kind != "exports") return not_found(call.path);
    if (!get) return not_allowed(call.method);
    const auto planned = workspace.planned();
    if (!planned) return refusal(404, {"plan", "is not made yet", "wait for the next event"});
    if (kind == "exports") {
        for (const Exporter& exporter : setup_.exporters)
            if (exporter.name == name) return export_reply(exporter, workspace.standing(), workspace.id());
        return not_found(call.path);
    }
    if (name == "drawing") return part_reply(planned->drawing, call);
    if (name == "drive") return part_reply(planned->drive, call);
    if (name == "samples") return samples_reply(*planned, call);
    if (name == "report") return part_reply(planned->report, call);
    return not_found(call.path);
}

Reply Api::answer_lettering(const Call& call) const {
    if (call.body.size() > largest_json)
        return refusal(413, {"body", "is larger than 8 MB", "write less at once"});
    const auto wanted = lettering_in(call.body);
    if (!wanted) return refusal(400, wanted.error());
    const auto document = setup_.letter(*wanted);
    if (!document) return refusal(422, document.error());
    return json_reply(200, lettered_text(*document));
}

}  // namespace strandline::serve
