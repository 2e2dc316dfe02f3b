#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <random>

#include "formats/sample_plan.hpp"
#include "result/formats/formats.hpp"

namespace strandline {
namespace {

using testing::sample_plan;

std::string good() { return formats::write_plan(sample_plan()); }
/// `from` once replaced by `to` in a good file.
std::string with(const std::string& from, const std::string& to) {
    std::string text = good();
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}
Error error_of(const std::string& text) {
    const auto plan = formats::read_plan(text, "plan.json");
    EXPECT_FALSE(plan);
    return plan ? Error{} : plan.error();
}
std::string refused(const std::string& from, const std::string& to) {
    return sentence(error_of(with(from, to)));
}
bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
#define EXPECT_SAYS(text, part) EXPECT_TRUE(says(text, part)) << (text)

TEST(PlanErrors, TextThatIsNotJsonIsRefusedWithLineAndColumn) {
    EXPECT_EQ(error_of("{\n\"format\": oops}").place, "plan.json, line 2, column 11");
    EXPECT_SAYS(sentence(error_of("{\n\"format\": oops}")), "not JSON");
    EXPECT_SAYS(sentence(error_of(" \n")), "the file is empty");
    EXPECT_SAYS(sentence(error_of(good().substr(0, 5000))), "not JSON");
}

TEST(PlanErrors, AnotherFormatAndAnotherVersionAreNamed) {
    EXPECT_SAYS(sentence(error_of("{}")), "not a plan");
    EXPECT_SAYS(sentence(error_of("[1,2]")), "not a plan");
    EXPECT_SAYS(refused("strandline-plan", "gpx"), "not a plan");
    EXPECT_SAYS(refused("\"version\": 1", "\"version\": 7"), "this file is version 7; this program reads 1");
    EXPECT_SAYS(refused("\"version\": 1", "\"version\": \"1\""), "version is missing");
}

TEST(PlanErrors, AMissingAnUnknownAndAMistypedFieldAreNamedByPointer) {
    EXPECT_SAYS(refused("\"rake_offset\":0.2,", ""), "/robot: \"rake_offset\" is missing");
    EXPECT_SAYS(refused("\"rake_offset\":", "\"rake_ofset\":1,\"rake_offset\":"),
                "\"rake_ofset\" is no key of it");
    EXPECT_SAYS(refused("\"rake_offset\":0.2", "\"rake_offset\":\"0.2\""),
                "/robot/rake_offset: a text where");
    EXPECT_SAYS(refused("\"id\":\"second\"", "\"id\":2"), "/drawing/elements/1/id");
    EXPECT_SAYS(refused("\"fill.spacing\":\"0\"", "\"fill.spacing\":\"-4\""), "/options/fill.spacing");
    EXPECT_SAYS(refused("\"link\"", "\"knot\""), "/edits/0/edit: \"knot\" is no edit");
}

TEST(PlanErrors, FilesWithoutTheKeysThatCameLaterAreReadWithTheirDefaults) {
    std::string text = good();
    for (const std::string key : {"\"can_back_up\":false,", "\"left_radius\":0,", "\"right_radius\":0,",
                                  "\"connect.extra_length\":\"0.1\","}) {
        ASSERT_NE(text.find(key), std::string::npos) << key;
        text.erase(text.find(key), key.size());
    }
    const auto plan = formats::read_plan(text, "plan.json");
    ASSERT_TRUE(plan) << sentence(plan.error());
    EXPECT_EQ(plan->robot, sample_plan().robot);
    EXPECT_EQ(plan->options, sample_plan().options);
}

TEST(PlanErrors, NumbersThatAreNotFiniteAreRefused) {
    Plan plan = sample_plan();
    plan.samples[3].pose.heading = std::nan("");
    EXPECT_SAYS(sentence(error_of(formats::write_plan(plan))),
                "/samples/heading/3: null where a finite number");
    EXPECT_SAYS(refused("\"t\":[0,", "\"t\":[NaN,"), "not JSON");
    EXPECT_SAYS(refused("\"t\":[0,", "\"t\":[1e999,"), "1e999");
}

TEST(PlanErrors, IndicesThatPointAtNothingAreRefused) {
    const auto refused_plan = [](auto&& change) {
        Plan plan = sample_plan();
        change(plan);
        return sentence(error_of(formats::write_plan(plan)));
    };
    EXPECT_SAYS(refused_plan([](Plan& p) { p.samples[5].stroke = 4; }), "/samples/stroke: sample 5");
    EXPECT_SAYS(refused_plan([](Plan& p) { p.samples[5].stroke = -2; }), "/samples/stroke: sample 5");
    EXPECT_SAYS(refused_plan([](Plan& p) { p.order[1].stroke = 9; }), "/order/1/stroke");
    EXPECT_SAYS(refused_plan([](Plan& p) { p.order[1].node = 2; }), "/order/1/node");
    EXPECT_SAYS(refused_plan([](Plan& p) { p.order.pop_back(); }), "3 entries for 4 strokes");
    EXPECT_SAYS(refused_plan([](Plan& p) { p.connections[2].to = 4; }), "/connections/2/to");
    EXPECT_SAYS(refused_plan([](Plan& p) { p.strokes[0].element = 3; }), "/strokes/0/element");
    EXPECT_SAYS(refused_plan([](Plan& p) { p.drawing.elements[2].inside = 2; }), "inside itself");
    EXPECT_SAYS(refused_plan([](Plan& p) { p.robot.pin_pitch = -1; }), "pin_pitch");
}

TEST(PlanErrors, ColumnsOfUnequalLengthAndHostileCountsAreRefused) {
    EXPECT_SAYS(refused("\"t\":[0,", "\"t\":["), "/samples");
    EXPECT_SAYS(refused("\"x\":[2.2,", "\"x\":["), "differ in length");
    EXPECT_SAYS(refused("\"mask\":[8,200", "\"mask\":[8,999999999999999999"), "/samples/mask/1");
    EXPECT_SAYS(refused("\"mask\":[8,200", "\"mask\":[8,-1"), "/samples/mask/1");
    EXPECT_SAYS(refused("\"mask\":[8,200,", "\"mask\":["), "add up to");
    EXPECT_SAYS(refused("\"mask\":[8,200", "\"mask\":[8"), "not a multiple of 2");
    EXPECT_SAYS(refused("\"motion\":[\"draw\"", "\"motion\":[\"fly\""), "\"fly\" is no motion");
    EXPECT_SAYS(refused("[\"M\",2,2,\"L\",6,2]", "[\"M\",2,2,\"L\",6]"),
                "/drawing/elements/0/draw/line/path");
    EXPECT_SAYS(refused("[\"M\",2,2,\"L\",6,2]", "[\"M\",2,2,\"Q\",6,2]"), "no segment of a path");
    EXPECT_FALSE(formats::read_plan(std::string(200'000, '['), "deep"));
}

/// A valid file after one to four random injuries.
std::string injured(std::string text, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto any = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    // Half of the injuries hit the last lines' big columns otherwise; the first half of the file holds the
    // structure.
    const auto place = [&] {
        return any(random() % 2 ? text.size() : std::min<std::size_t>(text.size(), 4000));
    };
    const std::vector<std::string> words{"null", "-1",   "1e308",      "\"\"", "[]",
                                         "{}",   "true", "4294967296", "1.5",  "\"Z\"",
                                         "99",   ",",    ":",          "-0.0", "18446744073709551615"};
    for (std::size_t n = 1 + any(4); n > 0 && !text.empty(); --n) {
        const std::size_t at = place();
        switch (any(4)) {
            case 0:
                text[at] = static_cast<char>(random());
                break;
            case 1:
                text.erase(at, 1 + any(40));
                break;
            case 2:
                text.insert(at, text.substr(place(), any(30)));
                break;
            default: {  // a whole value swapped for another kind
                const auto from = text.find_first_of(":,[", at);
                if (from == std::string::npos) break;
                const auto to = text.find_first_of(",]}", from + 1);
                if (to != std::string::npos) text.replace(from + 1, to - from - 1, words[any(words.size())]);
            }
        }
    }
    return text;
}

TEST(PlanErrors, AnInjuredFileGivesAPlanOrOneErrorAndNeverACrash) {
    const std::string text = good();
    EXPECT_TRUE(rc::check("injured files", [&](std::uint64_t seed) {
        const auto plan = formats::read_plan(injured(text, seed), "file");
        return plan ? formats::read_plan(formats::write_plan(*plan), "").has_value()
                    : !plan.error().place.empty() && !plan.error().reason.empty();
    }));
}

TEST(PlanErrors, AnEditThatCannotBeIsRefusedWithItsPlace) {
    const auto refusal = [](const std::string& edits) {
        const auto read = formats::read_edits(edits, "body");
        return read ? std::string() : sentence(read.error());
    };
    EXPECT_EQ(refusal(formats::write_edits(sample_plan().edits)), "");
    EXPECT_SAYS(refusal(R"([{"edit":"jump"}])"), "body/0/edit: \"jump\" is no edit");
    EXPECT_SAYS(refusal(R"([{"edit":"hint","element":"a","name":"colour","value":"red"}])"), "no such hint");
    EXPECT_SAYS(refusal(R"([{"edit":"hint","element":"a","name":"pins","value":"none"}])"), "pins");
    EXPECT_SAYS(refusal(R"([{"edit":"order","elements":[1]}])"), "body/0/elements/0");
    EXPECT_SAYS(refusal(R"([{"edit":"draw","element":"a","paths":[],"pins":1,"smooth":0}])"), "without");
    EXPECT_SAYS(refusal(R"([{"edit":"draw","element":"a","paths":[["M",1,1]],"pins":1,"smooth":0}])"),
                "body/0/paths/0: a path without a segment");
    EXPECT_SAYS(refusal(R"([{"edit":"draw","element":"a","paths":[["M",1,1,"L",2,2]],"pins":0,"smooth":0}])"),
                "one pin");
    const auto through = [](std::size_t poses, const char* more) {
        std::string text = R"([{"edit":"through","from":"a","to":"b","poses":[[0,0,0])";
        for (std::size_t i = 1; i < poses; ++i) text += ",[0,0,0]";
        return text + "]" + more + "}]";
    };
    EXPECT_EQ(refusal(through(ThroughEdit::most_poses, "")), "");
    EXPECT_SAYS(refusal(through(ThroughEdit::most_poses + 1, "")), "body/0/poses: 201 poses");
    EXPECT_SAYS(refusal(through(1, R"(,"hop":[0,0,1,1])")), "body/0/hop");
    EXPECT_SAYS(refusal(through(1, R"(,"hop":[0,0,1])")), "body/0/hop");
}

TEST(PlanErrors, ADriveWithinAnAreaIsReadAsItWasWritten) {
    const std::vector<Edit> edits{
        ThroughEdit{"a", "a", {{{1, 2}, 0.5}}, std::pair{Point{1, 2.25}, Point{3, 4}}}};
    const auto read = formats::read_edits(formats::write_edits(edits), "body");
    ASSERT_TRUE(read) << sentence(read.error());
    EXPECT_EQ(*read, edits);
}

}  // namespace
}  // namespace strandline
