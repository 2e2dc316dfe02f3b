// Rules as people write them.
#include <gtest/gtest.h>

#include "plan/model/model.hpp"

namespace strandline {
namespace {

std::string refusal(const std::string& text) {
    const auto rules = rules_of(text);
    return rules ? "" : sentence(rules.error());
}

TEST(Rules, ARuleSelectsAndAsks) {
    const auto rules = rules_of("layer=Out line*: pins=3, fill-style=zigzag ; colour=#FF00aa: tool=2");
    ASSERT_TRUE(rules);
    ASSERT_EQ(rules->size(), 2u);
    EXPECT_EQ(rules->at(0).pattern, "Out line*");
    EXPECT_EQ(rules->at(0).hints, (std::vector<svg::Hint>{{"pins", "3"}, {"fill-style", "zigzag"}}));
    EXPECT_EQ(rules->at(1).of, InkRule::Of::colour);
    EXPECT_EQ(rules->at(1).pattern, "#ff00aa");
    EXPECT_EQ(rules_of("id=path@3:7: tool=2")->at(0).pattern, "path@3:7");
    EXPECT_TRUE(rules_of("")->empty());
    // Commas and semicolons within a value: what goes on begins like a number.
    const auto cut = rules_of(
        "id=a: fill-cuts=0,2 4,2; -1,0 1.5,5, pins=3; id=b: fill-segments=1,1 style=rings; .5,2 direction=3");
    ASSERT_TRUE(cut) << sentence(cut.error());
    ASSERT_EQ(cut->size(), 2u);
    EXPECT_EQ(cut->at(0).hints, (std::vector<svg::Hint>{{"fill-cuts", "0,2 4,2;-1,0 1.5,5"}, {"pins", "3"}}));
    EXPECT_EQ(cut->at(1).hints,
              (std::vector<svg::Hint>{{"fill-segments", "1,1 style=rings;.5,2 direction=3"}}));
}

TEST(Rules, WhatCannotBeReadIsRefusedWithTheRule) {
    EXPECT_NE(refusal("layer=a: tool=2; nonsense").find("\"nonsense\": does not say what it is for"),
              std::string::npos);
    EXPECT_NE(refusal("page=a: tool=2").find("neither a layer"), std::string::npos);
    EXPECT_NE(refusal("colour=rouge: tool=2").find("#rrggbb"), std::string::npos);
    EXPECT_NE(refusal("layer=: tool=2").find("names nothing"), std::string::npos);
    EXPECT_NE(refusal("layer=a:").find("asks for nothing"), std::string::npos);
    EXPECT_NE(refusal("layer=a: tool=0").find("tool: \"0\" is not a whole number"), std::string::npos);
    EXPECT_NE(refusal("layer=a: fill-style=moon").find("\"moon\" is not a choice"), std::string::npos);
    EXPECT_NE(refusal("layer=a: colour=red").find("there is no such hint"), std::string::npos);
}

TEST(Rules, ASettingOfRulesIsCheckedWhenItIsSet) {
    Options options;
    EXPECT_TRUE(set(options, "drawing.rules", "id=eye: order=1"));
    EXPECT_EQ(options.drawing.rules, "id=eye: order=1");
    EXPECT_FALSE(set(options, "drawing.rules", "eye"));
    EXPECT_EQ(options.drawing.rules, "id=eye: order=1");
}

}  // namespace
}  // namespace strandline
