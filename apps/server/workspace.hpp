#pragma once
// One open project: its values, the plan of them, and the threads that make it.
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "events.hpp"
#include "folder.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "plan_parts.hpp"
#include "project.hpp"

namespace strandline::serve {

/// One thread that does the newest job: an older one that has not begun is forgotten, one under way is asked
/// to stop.
class Latest {
  public:
    using Job = std::function<void(const std::atomic<bool>& stop)>;
    Latest();
    ~Latest();
    Latest(const Latest&) = delete;
    Latest& operator=(const Latest&) = delete;
    void want(Job job);

  private:
    void work();
    std::mutex mutex_;
    std::condition_variable news_;
    std::optional<Job> next_;
    std::shared_ptr<std::atomic<bool>> stop_current_;
    bool ending_ = false;
    std::thread thread_;
};

/// A plan and the parts of it that are sent.
struct Planned {
    long long revision = 0;
    std::shared_ptr<const Plan> plan;  ///< a draft's may be without samples
    Part drawing, drive;
    std::shared_ptr<const SampleRow> samples;
    /// Those of plans before, the newest first: pages have one of them.
    std::vector<std::shared_ptr<const SampleRow>> before;
    Part report;  ///< tag "": not proved yet
};

/// What a client needs to know before it asks for more.
struct Standing {
    long long revision = 0;
    long long news = 0;  ///< grows whenever any of this changes: of two, the greater is the newer
    std::string title;
    State state;
    std::vector<std::string> undo, redo;  ///< what each step does, the next one last
    bool planning = false;                ///< `planned` is not the last word: of another revision, or a draft
    std::optional<Error> failure;         ///< of the newest planning
    std::shared_ptr<const Planned> planned;
};

class Workspace {
  public:
    /// The project is written to the folder with every change. `program` is what plans say made them.
    Workspace(std::string id, Project project, Folder folder, std::string program);
    ~Workspace();
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    const std::string& id() const { return id_; }
    Standing standing() const;
    std::string file_text() const;
    bool began_with(const SourceFile& source) const;
    std::shared_ptr<const Planned> planned() const;

    /// A change of the project that was at `revision`. Error: place "revision" when it is another by now;
    /// what `change` says; the file cannot be written. In every case but success the project is as before.
    using Edited = std::function<Outcome<void>(Project&)>;
    Outcome<long long> change(long long revision, const Edited& change);

    /// The project's file is deleted and every event stream ended; a change that comes later is refused with
    /// place "project".
    Outcome<void> remove();

    Hub& hub() { return hub_; }
    /// The event that says what holds now.
    Event standing_event() const;

  private:
    void plan_anew(const State& state, long long revision);
    Outcome<Draft> draft_or_plan(const State& state, bool draft, const Progress& progress);
    bool plan_and_publish(const State& state, long long revision, const std::atomic<bool>& stop, bool draft);
    std::shared_ptr<Planned> with_parts(Draft made, long long revision);
    bool refuse(const Error& error, long long revision);
    void forget();
    void get_ready(const State& state, const std::atomic<bool>& stop);
    bool publish(std::shared_ptr<Planned> planned, bool draft);
    void prove(const std::shared_ptr<const Planned>& planned, const std::atomic<bool>& stop);
    void tell_standing();

    const std::string id_, program_;
    const Folder folder_;
    mutable std::mutex mutex_;
    std::mutex telling_;  ///< taken before mutex_
    long long news_ = 0;
    Project project_;
    State state_;
    bool planning_ = false;
    std::optional<Error> failure_;
    std::shared_ptr<const Planned> planned_;
    bool removed_ = false;
    Hub hub_;
    std::unique_ptr<Planner> planner_;
    DrawingMaker drawings_;
    RowMaker rows_;
    // Last: they use all of the above. Planning gives proving its work, so it is ended first.
    std::unique_ptr<Latest> proving_thread_, planning_thread_;
};

}  // namespace strandline::serve
