// Steps, undo and the project file.
#include <gtest/gtest.h>

#include "projects.hpp"
#include "server/base64.hpp"
#include "server/project_text.hpp"

namespace strandline::serve {
namespace {

Project project() {
    Project p;
    p.title = "small.svg";
    p.sources.push_back(std::make_shared<const SourceFile>(SourceFile{"small.svg", small_drawing}));
    return p;
}
Step erase(const std::string& id) { return {"erase " + id, {EditChange{HintEdit{id, "ink", "off"}}}}; }

TEST(Project, UndoAndRedoGoBackAndForthWithoutLimit) {
    Project p = project();
    constexpr int steps = 200;
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(take_step(p, erase("e" + std::to_string(i))));
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(undo(p));
    EXPECT_TRUE(state_of(p)->edits.empty());
    EXPECT_FALSE(undo(p));
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(redo(p));
    EXPECT_EQ(state_of(p)->edits.size(), static_cast<std::size_t>(steps));
    EXPECT_FALSE(redo(p));
    EXPECT_EQ(p.revision, 1 + 3 * steps);
}

TEST(Project, AStepAfterUndoTakesThePlaceOfWhatWasUndone) {
    Project p = project();
    ASSERT_TRUE(take_step(p, erase("a")));
    ASSERT_TRUE(take_step(p, erase("b")));
    ASSERT_TRUE(undo(p));
    ASSERT_TRUE(take_step(p, erase("c")));
    EXPECT_FALSE(redo(p));
    const State state = *state_of(p);
    ASSERT_EQ(state.edits.size(), 2u);
    EXPECT_EQ(std::get<HintEdit>(state.edits[1]).element, "c");
}

TEST(Project, ARefusedStepLeavesTheProjectAsItWas) {
    Project p = project();
    ASSERT_TRUE(take_step(p, erase("a")));
    ASSERT_TRUE(undo(p));
    const std::string before = write_project(p);
    const auto refused = take_step(p, {"wrong", {SetChange{"fill.spacing", "blue"}}});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().place, "fill.spacing");
    EXPECT_EQ(write_project(p), before);
    EXPECT_TRUE(redo(p));
}

TEST(Project, AnEditTakesThePlaceOfTheOneAboutTheSameThing) {
    Project p = project();
    const auto link = [](const std::string& to) { return EditChange{LinkEdit{{"a", 0}, {to, 1}}}; };
    ASSERT_TRUE(take_step(p, {"", {link("b")}}));
    ASSERT_TRUE(take_step(p, {"", {link("c")}}));
    ASSERT_EQ(state_of(p)->edits.size(), 1u);
    EXPECT_EQ(std::get<LinkEdit>(state_of(p)->edits[0]).b.element, "c");
    ASSERT_TRUE(take_step(p, {"", {DropChange{LinkEdit{{"c", 1}, {"x", 0}}}}}));
    EXPECT_TRUE(state_of(p)->edits.empty());
}

TEST(Project, SettingsFollowTheCanvasUnlessTheyAreSet) {
    Project p = project();
    ASSERT_TRUE(take_step(p, {"", {SetChange{"canvas.width", "0.21"}, SetChange{"canvas.height", "0.297"}}}));
    EXPECT_LT(state_of(p)->options.canvas.margin, 0.01);
    ASSERT_TRUE(take_step(p, {"", {SetChange{"canvas.margin", "2cm"}}}));
    EXPECT_DOUBLE_EQ(state_of(p)->options.canvas.margin, 0.02);
    ASSERT_TRUE(take_step(p, {"", {SetChange{"canvas.margin", ""}}}));
    EXPECT_LT(state_of(p)->options.canvas.margin, 0.01);
}

TEST(Project, ARobotOfOnesOwnIsTakenByItsProfile) {
    Project p = project();
    const std::string toml = "base = \"turf\"\nname = \"mine\"\nmin_radius = 0.8\n";
    ASSERT_TRUE(take_step(p, {"", {SetChange{"robot.profile", toml}, SetChange{"robot.speed", "0.4"}}}));
    const State state = *state_of(p);
    EXPECT_EQ(state.robot_name, "mine");
    EXPECT_DOUBLE_EQ(state.robot.min_radius, 0.8);
    EXPECT_DOUBLE_EQ(state.robot.speed, 0.4);
    EXPECT_EQ(state.robot.pins, builtin_robot("turf")->pins);
    EXPECT_EQ(state_of(*read_project(write_project(p), "p"))->robot, state.robot);
    const auto wrong = take_step(p, {"", {SetChange{"robot.profile", "min_radius = -1"}}});
    ASSERT_FALSE(wrong);
    EXPECT_NE(sentence(wrong.error()).find("min_radius"), std::string::npos);
    ASSERT_TRUE(take_step(p, {"", {SetChange{"robot.profile", ""}}}));
    EXPECT_EQ(state_of(p)->robot_name, "beachbot");
}

TEST(Project, WrittenAndReadItIsTheSame) {
    Project p = project();
    p.sources.push_back(
        std::make_shared<const SourceFile>(SourceFile{"bytes", std::string("\x89PNG\0\xff", 6)}));
    ASSERT_TRUE(take_step(p, erase("a")));
    const Path path = path_through({{0, 0}, {1.25, 0.1}, {3, 1}}, false);
    ASSERT_TRUE(
        take_step(p, {"draw", {EditChange{DrawEdit{"pen1", {path}, 3, 0.02}}, SetChange{"robot", "turf"}}}));
    ASSERT_TRUE(take_step(p, {"", {EditChange{OrderEdit{{"b", "a"}}}, SourceChange{1}}}));
    ASSERT_TRUE(undo(p));
    const auto again = read_project(write_project(p), "file");
    ASSERT_TRUE(again) << sentence(again.error());
    EXPECT_EQ(write_project(*again), write_project(p));
    EXPECT_EQ(state_of(*again)->edits, state_of(p)->edits);
    EXPECT_EQ(*again->sources[1], *p.sources[1]);
    EXPECT_EQ(again->done, 2u);
}

TEST(Project, AFileThatIsNoneIsRefusedWithItsPlace) {
    const std::string good = write_project(project());
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"strandline-project", "other"},
             {"\"version\": 1", "\"version\": 7"},
             {"\"done\": 0", "\"done\": 3"},
             {"\"done\": 0", "\"done\": -1"},
             {"\"steps\": []",
              "\"steps\": [{\"what\":\"\",\"changes\":[{\"set\":\"no.key\",\"value\":\"1\"}]}]"},
             {"\"steps\": []", "\"steps\": [{\"what\":\"\",\"changes\":[{\"source\":4}]}]"},
             {"\"sources\": [", "\"sources\": [5, "}}) {
        std::string bad = good;
        const auto at = bad.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        bad.replace(at, from.size(), to);
        // The key alone is only read where the step is done.
        if (bad.find("no.key") != std::string::npos) bad.replace(bad.find("\"done\": 0"), 9, "\"done\": 1");
        const auto read = read_project(bad, "file");
        ASSERT_FALSE(read) << to;
        EXPECT_FALSE(read.error().reason.empty());
    }
    for (std::size_t cut = 0; cut < good.size(); cut += 37)
        EXPECT_FALSE(read_project(good.substr(0, cut), "file"));
}

TEST(Base64, IsItsOwnInverseAndRefusesWhatIsNone) {
    std::string bytes;
    for (int n = 0; n < 70; ++n, bytes += static_cast<char>(37 * n)) {
        const auto again = bytes_of_base64(base64_of(bytes));
        ASSERT_TRUE(again);
        EXPECT_EQ(*again, bytes);
    }
    EXPECT_EQ(base64_of("Strand"), "U3RyYW5k");
    EXPECT_EQ(base64_of("sea!"), "c2VhIQ==");
    for (const char* wrong : {"a", "ab=c", "ab*=", "====", "abc"})
        EXPECT_FALSE(bytes_of_base64(wrong)) << wrong;
}

}  // namespace
}  // namespace strandline::serve
