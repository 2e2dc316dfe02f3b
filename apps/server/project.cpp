#include "project.hpp"

#include <algorithm>
#include <utility>

#include "plan/pipeline/pipeline.hpp"

namespace strandline::serve {
namespace {

template <class... F>
struct Visit : F... {
    using F::operator()...;
};

constexpr std::string_view robot_prefix = "robot.";
constexpr std::string_view robot_profile = "robot.profile";

Outcome<void> set_up_robot(State& state) {
    const auto base = state.settings.find("robot");
    state.robot_name = base == state.settings.end() ? "beachbot" : base->second;
    const auto profile = state.settings.find(std::string(robot_profile));
    const bool own = profile != state.settings.end();
    auto robot = own ? read_robot(profile->second, profile->first) : builtin_robot(state.robot_name);
    if (own && robot) state.robot_name = robot->name;
    for (const auto& [key, value] : state.settings)
        if (robot && key.starts_with(robot_prefix) && key != robot_profile)
            robot = with_field(*robot, key.substr(robot_prefix.size()), value);
    if (!robot) return tl::unexpected(robot.error());
    state.robot = std::move(*robot);
    return {};
}

Outcome<void> set_all(Options& options, const std::map<std::string, std::string>& settings) {
    for (const auto& [key, value] : settings) {
        if (key == "robot" || key.starts_with(robot_prefix)) continue;
        if (auto done = set(options, key, value); !done) return done;
    }
    return {};
}

/// Twice: the canvas that is wished for decides the defaults of all that is not.
Outcome<void> set_up_options(State& state) {
    Options first;
    if (auto done = set_all(first, state.settings); !done) return done;
    state.options = defaults_for({first.canvas.width, first.canvas.height});
    return set_all(state.options, state.settings);
}

void take_out(std::vector<Edit>& edits, const Edit& edit) {
    std::erase_if(edits, [&](const Edit& other) { return same_thing(edit, other); });
}

void put_in(std::vector<Edit>& edits, const Edit& edit) {
    const auto same = std::ranges::find_if(edits, [&](const Edit& e) { return same_thing(e, edit); });
    if (same == edits.end() || std::holds_alternative<LinkEdit>(edit)) {
        take_out(edits, edit);
        edits.push_back(edit);
    } else {
        *same = edit;
    }
}

bool tied_at(const LinkEdit& a, const LinkEdit& b) {
    return a.a == b.a || a.a == b.b || a.b == b.a || a.b == b.b;
}

}  // namespace

bool is_bare(const State& state) {
    return !state.source || (state.source->bytes.empty() && state.edits.empty());
}

bool same_thing(const Edit& a, const Edit& b) {
    if (a.index() != b.index()) return false;
    const Visit compare{
        [&](const LinkEdit& edit) { return tied_at(edit, std::get<LinkEdit>(b)); },
        [&](const EntryEdit& edit) { return edit.at.element == std::get<EntryEdit>(b).at.element; },
        [&](const DirectionEdit& edit) { return edit.element == std::get<DirectionEdit>(b).element; },
        [&](const HintEdit& edit) {
            const auto& other = std::get<HintEdit>(b);
            return edit.element == other.element && edit.name == other.name;
        },
        [](const OrderEdit&) { return true; },
        [&](const DrawEdit& edit) { return edit.element == std::get<DrawEdit>(b).element; },
        [&](const ThroughEdit& edit) {
            const auto& other = std::get<ThroughEdit>(b);
            return edit.hop == other.hop && ((edit.from == other.from && edit.to == other.to) ||
                                             (edit.from == other.to && edit.to == other.from));
        }};
    return std::visit(compare, a);
}

Outcome<State> state_of(const Project& project) {
    State state;
    if (!project.sources.empty()) state.source = project.sources.front();
    const Visit apply{[&](const SetChange& change) {
                          if (change.value.empty())
                              state.settings.erase(change.key);
                          else
                              state.settings[change.key] = change.value;
                      },
                      [&](const EditChange& change) { put_in(state.edits, change.edit); },
                      [&](const DropChange& change) { take_out(state.edits, change.edit); },
                      [&](const SourceChange& change) {
                          state.source = project.sources.at(static_cast<std::size_t>(change.source));
                      }};
    for (std::size_t i = 0; i < project.done; ++i)
        for (const Change& change : project.steps[i].changes) std::visit(apply, change);
    if (auto done = set_up_robot(state); !done) return tl::unexpected(done.error());
    if (auto done = set_up_options(state); !done) return tl::unexpected(done.error());
    if (auto fits = valid(state.options, state.robot); !fits) return tl::unexpected(fits.error());
    return state;
}

Outcome<void> take_step(Project& project, Step step) {
    if (step.changes.empty()) return fail("changes", "the step changes nothing", "name at least one change");
    std::vector<Step> undone(project.steps.begin() + static_cast<std::ptrdiff_t>(project.done),
                             project.steps.end());
    project.steps.resize(project.done);
    project.steps.push_back(std::move(step));
    ++project.done;
    if (const auto state = state_of(project); !state) {
        project.steps.pop_back();
        --project.done;
        project.steps.insert(project.steps.end(), undone.begin(), undone.end());
        return tl::unexpected(state.error());
    }
    ++project.revision;
    return {};
}

Outcome<void> undo(Project& project) {
    if (project.done == 0) return fail("undo", "nothing has been changed yet");
    --project.done;
    ++project.revision;
    return {};
}

Outcome<void> redo(Project& project) {
    if (project.done == project.steps.size()) return fail("redo", "nothing was undone");
    ++project.done;
    ++project.revision;
    return {};
}

}  // namespace strandline::serve
