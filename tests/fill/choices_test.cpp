// Which choices a style reads.
#include <gtest/gtest.h>

#include "path/fill/fill.hpp"

namespace strandline::fill {
namespace {

/// Everything chosen otherwise than by default.
Options all_chosen(Style style) {
    Options options{.style = style, .insets = Insets::skeleton, .join = Join::nearest, .shift = 5};
    options.direction = 0.3;
    options.partition = Partition::monotone;
    options.cuts = {{{3, -1}, {3, 7}}};
    options.part_inset = 0.1;
    options.border = options.rake_turns = false;
    return options;
}
std::vector<std::string_view> unread(const Options& options) {
    std::vector<std::string_view> names;
    for (const Choice& choice : choices_of(options))
        if (!choice.read) names.push_back(choice.name);
    return names;
}

TEST(FillChoices, EachStyleNamesWhatItDoesNotRead) {
    EXPECT_TRUE(choices_of({}).empty());
    using Names = std::vector<std::string_view>;
    EXPECT_EQ(unread(all_chosen(Style::rings)),
              (Names{"shift", "direction", "partition", "cuts", "part_inset", "border", "rake_turns"}));
    EXPECT_EQ(unread(all_chosen(Style::spiral)),
              (Names{"join", "direction", "partition", "cuts", "part_inset", "border", "rake_turns"}));
    EXPECT_EQ(unread(all_chosen(Style::zigzag)), (Names{"inset", "join", "shift"}));
}

TEST(FillChoices, WhatOneSegmentOfAZigzagReadsIsRead) {
    Options options = all_chosen(Style::zigzag);
    options.segments = {{{1, 1}, {}, Style::rings}};
    EXPECT_EQ(unread(options), (std::vector<std::string_view>{"shift"}));
}

TEST(FillChoices, WhatIsNotReadChangesNothing) {
    const Region area{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {}};
    for (Style style : {Style::rings, Style::spiral}) {
        Options options = all_chosen(style), plain{.style = style};
        plain.insets = options.insets;
        if (style == Style::rings) plain.join = options.join;
        if (style == Style::spiral) plain.shift = options.shift;
        EXPECT_EQ(fill_region(area, 0, "area", options).strokes, fill_region(area, 0, "area", plain).strokes);
    }
}

}  // namespace
}  // namespace strandline::fill
