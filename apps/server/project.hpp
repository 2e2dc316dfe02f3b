#pragma once
// A project: drawings, and every step of changes to settings, robot and edits since. What holds now is those
// steps gone through in order, so undo and redo only move along them. Values only; no file, no clock.
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "plan/model/model.hpp"

namespace strandline::serve {

/// A drawing's file: SVG, PNG or JPEG; empty for a project that begins with bare sand.
struct SourceFile {
    std::string title, bytes;
    bool operator==(const SourceFile&) const = default;
};

/// "fill.spacing", "robot" (a built-in's name), "robot.profile" (TOML; goes before the name), "robot.FIELD".
/// Empty value: back to what it is by default.
struct SetChange {
    std::string key, value;
};
/// An edit that takes the place of the one about the same thing (same_thing()), or comes last.
struct EditChange {
    Edit edit;
};
/// The edit about the same thing is taken back.
struct DropChange {
    Edit edit;
};
/// Another drawing, by its number in Project::sources.
struct SourceChange {
    int source = 0;
};
using Change = std::variant<SetChange, EditChange, DropChange, SourceChange>;
struct Step {
    std::string what;  ///< for people: "erase eye"
    std::vector<Change> changes;
};

struct Project {
    static constexpr int current_version = 1;
    std::string title;
    std::vector<std::shared_ptr<const SourceFile>> sources;  ///< the first is the one it began with
    std::vector<Step> steps;
    std::size_t done = 0;    ///< steps that hold; those after them can be redone
    long long revision = 1;  ///< grows by one with every change, undo and redo too
};

/// What holds after the steps done.
struct State {
    std::shared_ptr<const SourceFile> source;
    std::map<std::string, std::string> settings;  ///< what was set, by key
    std::string robot_name = "beachbot";
    Robot robot;
    Options options;
    std::vector<Edit> edits;
};

/// Neither a drawing nor an edit: a sketch before its first line.
bool is_bare(const State& state);

/// Whether one takes the other's place: the same node tied, element entered or turned, hint of an element,
/// element drawn; there is one order.
bool same_thing(const Edit& a, const Edit& b);

/// Error: a setting or robot field that cannot have that value, by its key.
Outcome<State> state_of(const Project& project);
/// One step more, in the place of those that were undone. Error: as state_of; the project is as before.
Outcome<void> take_step(Project& project, Step step);
/// Error: nothing to undo, or to redo.
Outcome<void> undo(Project& project);
Outcome<void> redo(Project& project);

}  // namespace strandline::serve
