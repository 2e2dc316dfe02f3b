#include "workspace.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <nlohmann/json.hpp>
#include <utility>

#include "plan/pipeline/pipeline.hpp"
#include "project_text.hpp"

namespace strandline::serve {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json json_of(const Error& error) {
    return {{"place", error.place}, {"reason", error.reason}, {"remedy", error.remedy}};
}

/// Thrown out of a progress report: how planning that nobody waits for any more is left at once.
struct Outdated {};

/// Tells how far planning is, not more often than a person can see.
Progress progress_to(Hub& hub, long long revision, const std::atomic<bool>& stop, double seconds) {
    static constexpr std::chrono::milliseconds pause(60);
    const auto begun = Clock::now();
    auto told = std::make_shared<Clock::time_point>(begun);
    Progress progress;
    progress.report = [&hub, &stop, revision, told](const std::string& what, double share) {
        if (stop) throw Outdated();
        const auto now = Clock::now();
        if (now - *told < pause) return;
        *told = now;
        hub.tell({"progress", line_of({{"revision", revision}, {"what", what}, {"share", share}})});
    };
    progress.stopped = [&stop, begun, seconds] {
        return stop || (seconds > 0 && Clock::now() - begun > std::chrono::duration<double>(seconds));
    };
    return progress;
}

}  // namespace

Workspace::Workspace(std::string id, Project project, Folder folder, std::string program)
    : id_(std::move(id)),
      program_(std::move(program)),
      folder_(std::move(folder)),
      project_(std::move(project)),
      planner_(std::make_unique<Planner>()),
      proving_thread_(std::make_unique<Latest>()),
      planning_thread_(std::make_unique<Latest>()) {
    // A project that was read has a state: read_project() made sure.
    state_ = *state_of(project_);
    plan_anew(state_, project_.revision);
}

Workspace::~Workspace() { hub_.close(); }

Standing Workspace::standing() const {
    const std::lock_guard lock(mutex_);
    Standing standing{project_.revision, news_,    project_.title, state_, {}, {},
                      planning_,         failure_, planned_};
    for (std::size_t i = 0; i < project_.steps.size(); ++i)
        if (i < project_.done) standing.undo.push_back(project_.steps[i].what);
    for (std::size_t i = project_.steps.size(); i > project_.done; --i)
        standing.redo.push_back(project_.steps[i - 1].what);
    return standing;
}

std::string Workspace::file_text() const {
    const std::lock_guard lock(mutex_);
    return write_project(project_);
}

bool Workspace::began_with(const SourceFile& source) const {
    const std::lock_guard lock(mutex_);
    return *project_.sources.front() == source;
}

std::shared_ptr<const Planned> Workspace::planned() const {
    const std::lock_guard lock(mutex_);
    return planned_;
}

Event Workspace::standing_event() const {
    const std::lock_guard lock(mutex_);
    Json parts;
    if (planned_)
        parts = {{"revision", planned_->revision},
                 {"drawing", planned_->drawing.tag},
                 {"drive", planned_->drive.tag},
                 {"samples", planned_->samples->tag},
                 {"report", planned_->report.tag}};
    return {"standing", line_of({{"revision", project_.revision},
                                 {"news", news_},
                                 {"planning", planning_},
                                 {"failure", failure_ ? json_of(*failure_) : Json()},
                                 {"plan", std::move(parts)}})};
}

/// One at a time: what is told last is what holds.
void Workspace::tell_standing() {
    const std::lock_guard lock(telling_);
    hub_.tell(standing_event());
}

Outcome<long long> Workspace::change(long long revision, const Edited& change) {
    {
        const std::lock_guard lock(mutex_);
        if (removed_) return fail("project", "was deleted", "open another one");
        if (revision != project_.revision)
            return fail("revision",
                        fmt::format("{} is not the newest: it is {}", revision, project_.revision),
                        "take over what others changed, then change it again");
        Project changed = project_;
        if (const auto done = change(changed); !done) return tl::unexpected(done.error());
        auto state = state_of(changed);
        if (!state) return tl::unexpected(state.error());
        if (const auto saved = folder_.write(id_, write_project(changed)); !saved)
            return tl::unexpected(saved.error());
        project_ = std::move(changed);
        state_ = std::move(*state);
        revision = project_.revision;
        ++news_;
        plan_anew(state_, revision);
    }
    tell_standing();
    return revision;
}

Outcome<void> Workspace::remove() {
    {
        const std::lock_guard lock(mutex_);
        if (const auto gone = folder_.remove(id_); !gone) return gone;
        removed_ = true;
    }
    hub_.close();
    return {};
}

/// A draft first: it is on the screen while the search goes on. The stages that both share are made once.
/// Under the lock, or before anyone else knows of this.
void Workspace::plan_anew(const State& state, long long revision) {
    planning_ = true;
    planning_thread_->want([this, state, revision](const std::atomic<bool>& stop) {
        if (plan_and_publish(state, revision, stop, true) && plan_and_publish(state, revision, stop, false))
            get_ready(state, stop);
    });
}

Outcome<Draft> Workspace::draft_or_plan(const State& state, bool draft, const Progress& progress) {
    const Source source{state.source->bytes, state.source->title};
    if (draft) return planner_->draft(source, state.robot, state.options, state.edits, progress);
    auto plan = planner_->plan(source, state.robot, state.options, state.edits, progress);
    if (!plan) return tl::unexpected(plan.error());
    return Draft{std::move(*plan), {}};
}

/// False: there is no plan, or nobody waits for it any more. Nothing is thrown out of here: it is the
/// thread's last function.
bool Workspace::plan_and_publish(const State& state, long long revision, const std::atomic<bool>& stop,
                                 bool draft) {
    try {
        if (is_bare(state))
            return !stop && refuse({"drawing", "nothing is drawn yet", "draw, write, or drop a drawing here"},
                                   revision);
        auto made =
            draft_or_plan(state, draft, progress_to(hub_, revision, stop, state.options.tour.time_limit));
        if (stop) return false;
        if (!made) return refuse(made.error(), revision);
        return publish(with_parts(std::move(*made), revision), draft);
    } catch (const Outdated&) {
        return false;
    } catch (const std::exception& error) {
        forget();
        return !stop &&
               refuse({"planning", error.what(), "undo the last change, and report this with the project"},
                      revision);
    }
}

std::shared_ptr<Planned> Workspace::with_parts(Draft made, long long revision) {
    made.plan.program = program_;
    auto planned = std::make_shared<Planned>();
    planned->revision = revision;
    planned->plan = std::make_shared<const Plan>(std::move(made.plan));
    planned->samples =
        planned->plan->samples.empty() ? rows_.row_of(made.pieces) : rows_.row_of(*planned->plan);
    planned->drawing = drawings_.part(planned->plan);
    planned->drive = drive_part(*planned->plan, *planned->samples);
    if (const auto last = this->planned()) {
        constexpr std::size_t most_before = 4;
        planned->before = {last->samples};
        planned->before.insert(planned->before.end(), last->before.begin(), last->before.end());
        if (planned->before.size() > most_before) planned->before.resize(most_before);
    }
    return planned;
}

/// Why there is no plan of this revision. False.
bool Workspace::refuse(const Error& error, long long revision) {
    {
        const std::lock_guard lock(mutex_);
        if (revision != project_.revision) return false;
        planning_ = false;
        ++news_;
        failure_ = error;
        if (is_bare(state_)) planned_.reset();  // what was drawn before is no part of it
    }
    tell_standing();
    return false;
}

/// What is kept from plan to plan may have been left half-done: the next one is made from nothing.
void Workspace::forget() {
    planner_ = std::make_unique<Planner>();
    drawings_ = {};
    rows_ = {};
}

/// A draft of what is there already: the next one finds the pieces of this drive made, and only what its edit
/// touches is new.
void Workspace::get_ready(const State& state, const std::atomic<bool>& stop) {
    Progress progress;
    progress.report = [&stop](const std::string&, double) {
        if (stop) throw Outdated();
    };
    progress.stopped = [&stop] { return stop.load(); };
    try {
        const auto draft = draft_or_plan(state, true, progress);
        if (draft && !draft->pieces.empty()) rows_.row_of(draft->pieces);
    } catch (const Outdated&) {
        return;
    } catch (const std::exception&) {
        forget();  // the next edit is planned from nothing, and tells
    }
}

bool Workspace::publish(std::shared_ptr<Planned> planned, bool draft) {
    {
        const std::lock_guard lock(mutex_);
        if (planned->revision != project_.revision) return false;
        planning_ = draft;
        ++news_;
        failure_.reset();
        planned_ = planned;
    }
    tell_standing();
    if (draft) return true;
    proving_thread_->want([this, planned](const std::atomic<bool>& stop) { prove(planned, stop); });
    return true;
}

/// Nothing is thrown out of here: it is the thread's last function.
void Workspace::prove(const std::shared_ptr<const Planned>& planned, const std::atomic<bool>& stop) {
    auto proved = std::make_shared<Planned>(*planned);
    std::optional<Error> failure;
    try {
        const check::Report report = check::prove(*planned->plan);
        if (stop) return;
        proved->report = report_part(report);
    } catch (const std::exception& error) {
        failure = {"check", error.what(), "report this with the project"};
    }
    {
        const std::lock_guard lock(mutex_);
        if (planned_ != planned) return;
        if (failure)
            failure_ = failure;
        else
            planned_ = std::move(proved);
        ++news_;
    }
    tell_standing();
}

}  // namespace strandline::serve
