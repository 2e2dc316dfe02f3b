// Layers, rules and hints: which shapes are drawn, and what is asked for each.
#include <gtest/gtest.h>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

using Ids = std::vector<std::string>;
using Names = std::vector<std::string>;

/// a in "Sky", b in "Sea" in "Sky", c in "%guides", d in "!gold", e in none.
svg::Document layered() {
    svg::Document d =
        document({stroked(line({{0, 0}, {10, 0}}), 0.3), stroked(line({{0, 10}, {10, 10}}), 0.3),
                  stroked(line({{0, 20}, {10, 20}}), 0.3), stroked(line({{0, 30}, {10, 30}}), 0.3),
                  stroked(line({{0, 40}, {10, 40}}), 0.3)});
    d.layers = {
        {"Sky", "s", -1, true}, {"Sea", "w", 0, true}, {"%guides", "g", -1, true}, {"!gold", "o", -1, true}};
    for (int k = 0; k < 4; ++k) d.shapes[static_cast<std::size_t>(k)].layer_index = k;
    return d;
}
Drawing drawn_with(const svg::Document& d, const DrawingOptions& options) {
    auto drawing = make_drawing(d, beachbot(), options);
    if (!drawing) throw std::runtime_error(sentence(drawing.error()));
    return *drawing;
}
Ids drawn_layers(const Names& layers) {
    DrawingOptions options = metre_a_unit();
    options.layers = layers;
    return ids(drawn_with(layered(), options));
}

TEST(Choices, APercentSignLeavesALayerOutAndNamesChooseAmongTheRest) {
    EXPECT_EQ(drawn_layers({}), (Ids{"a", "b", "d", "e"}));
    EXPECT_EQ(drawn_layers({"Sky"}), (Ids{"a", "b"})) << "layers in it are part of it";
    EXPECT_EQ(drawn_layers({"Sea", "!*"}), (Ids{"b", "d"}));
}

TEST(Choices, ALayerThatIsNotThereIsRefusedWithTheNamesOfThoseThatAre) {
    DrawingOptions options = metre_a_unit();
    options.layers = {"Ski"};
    const auto refused = make_drawing(layered(), beachbot(), options);
    ASSERT_FALSE(refused);
    EXPECT_NE(sentence(refused.error()).find("\"Sky\", \"Sea\""), std::string::npos);
}

TEST(Choices, RulesApplyInOrderAndTheFilesOwnHintsWin) {
    svg::Document d = layered();
    d.shapes[1].hints = {{"tool", "9"}};
    DrawingOptions options = metre_a_unit();
    options.rules = {{InkRule::Of::layer, "S*", {{"tool", "2"}, {"pins", "5"}}},
                     {InkRule::Of::layer, "Sea", {{"tool", "3"}, {"pins", "3"}}},
                     {InkRule::Of::colour, "#000000", {{"order", "4"}}},
                     {InkRule::Of::id, "e", {{"ink", "off"}}}};
    const Drawing drawing = drawn_with(d, options);
    EXPECT_EQ(ids(drawing), (Ids{"a", "b", "d"}));
    EXPECT_EQ(line_of(drawing, 0).pins, 5);
    EXPECT_EQ(line_of(drawing, 1).pins, 3);
    EXPECT_EQ(drawing.elements[0].hints, (std::vector<svg::Hint>{{"order", "4"}, {"tool", "2"}}));
    EXPECT_EQ(drawing.elements[1].hints, (std::vector<svg::Hint>{{"order", "4"}, {"tool", "9"}}));
    EXPECT_EQ(drawing.elements[2].hints, (std::vector<svg::Hint>{{"order", "4"}, {"pause", "!gold"}}));
    EXPECT_EQ(drawing.counts.unchosen, 2);
}

TEST(Choices, ARuleThatMeansNothingIsAWarning) {
    DrawingOptions options = metre_a_unit();
    options.rules = {{InkRule::Of::layer, "Sku", {{"tool", "2"}}}};
    const Drawing drawing = drawn_with(layered(), options);
    ASSERT_EQ(drawing.warnings.size(), 1u);
    EXPECT_EQ(drawing.warnings[0].place, "rule for \"Sku\"");
}

TEST(Choices, ALayerThatIsNeverDrawnCannotBeChosen) {
    DrawingOptions options = metre_a_unit();
    options.layers = {"%guides"};
    const auto refused = make_drawing(layered(), beachbot(), options);
    ASSERT_FALSE(refused);
    EXPECT_NE(sentence(refused.error()).find("never drawn"), std::string::npos);
}

TEST(Choices, PinsAskedForMakeALineOfAWideStroke) {
    svg::Shape wide = stroked(line({{0, 0}, {10, 0}}), 3);
    EXPECT_TRUE(is_region(drawn({wide}).elements[0]));
    wide.hints = {{"pins", "2"}};
    EXPECT_EQ(line_of(drawn({wide}), 0).pins, 2);
}

TEST(Choices, InkOnDrawsWhatTheThresholdCallsBare) {
    svg::Shape pale = shape({square({0, 0}, 10)}, white, {});
    pale.hints = {{"ink", "on"}};
    EXPECT_EQ(drawn({pale}).elements.size(), 1u);
}

TEST(Choices, PinsThatTheRakeDoesNotHaveAreAWarning) {
    svg::Shape wide = stroked(line({{0, 0}, {10, 0}}), 0.3);
    wide.hints = {{"pins", "8"}};
    const Drawing drawing = drawn({wide});
    EXPECT_EQ(line_of(drawing, 0).pins, 1);
    ASSERT_EQ(drawing.warnings.size(), 1u);
    EXPECT_EQ(drawing.warnings[0].place, "<path> #a");
}

TEST(Choices, AreasOfDifferentHintsDoNotMergeTheLaterCuts) {
    svg::Shape below = filled({square({0, 0}, 20)}), above = filled({square({10, 0}, 20)});
    above.hints = {{"fill-style", "zigzag"}};
    const Drawing drawing = drawn({below, above});
    ASSERT_EQ(drawing.elements.size(), 2u);
    EXPECT_NEAR(area(region_of(drawing, 0)), 200, 1e-3);
    EXPECT_NEAR(area(region_of(drawing, 1)), 400, 1e-3);
}

TEST(Choices, LinesOfDifferentHintsDoNotJoin) {
    svg::Shape first = stroked(line({{0, 0}, {10, 0}})), second = stroked(line({{10, 0}, {20, 0}}));
    EXPECT_EQ(drawn({first, second}).elements.size(), 1u);
    second.hints = {{"tool", "2"}};
    EXPECT_EQ(drawn({first, second}).elements.size(), 2u);
}

TEST(Choices, FencesAreNotDrawnHideNothingAndDoNotCountForTheSize) {
    svg::Shape rock = filled({square({80, 80}, 30)}), wall = stroked(line({{0, 50}, {50, 50}}), 2),
               edge = filled({square({-10, -10}, 120)});
    rock.hints = wall.hints = {{"field", "keep-out"}};
    edge.hints = {{"field", "border"}};
    const std::vector<svg::Shape> art{stroked(line({{0, 0}, {10, 0}})), filled({square({20, 20}, 20)})};
    const Drawing bare = drawn(art), fenced = drawn({art[0], edge, rock, art[1], wall});
    EXPECT_EQ(fenced.elements.size(), bare.elements.size());
    EXPECT_EQ(fenced.to_canvas, bare.to_canvas);
    ASSERT_EQ(fenced.keep_out.size(), 2u);
    EXPECT_NEAR(area(fenced.keep_out[0]), 900 * fenced.scale * fenced.scale, 1e-3);
    EXPECT_NEAR(area(fenced.keep_out[1]), (100 + pi) * fenced.scale * fenced.scale, 0.1);
    ASSERT_TRUE(fenced.border);
    EXPECT_NEAR(area(*fenced.border), 120 * 120 * fenced.scale * fenced.scale, 1e-3);
    EXPECT_TRUE(fenced.warnings.empty());
}

TEST(Choices, AFenceWithoutAreaOrASecondBorderIsAWarning) {
    svg::Shape flat = filled({line({{0, 0}, {10, 0}})}), edge = filled({square({0, 0}, 50)});
    flat.hints = {{"field", "keep-out"}};
    edge.hints = {{"field", "border"}};
    const Drawing drawing = drawn({stroked(line({{0, 0}, {10, 0}})), flat, edge, edge});
    EXPECT_TRUE(drawing.keep_out.empty());
    ASSERT_EQ(drawing.warnings.size(), 2u);
    EXPECT_NE(drawing.warnings[0].reason.find("without area"), std::string::npos);
    EXPECT_NE(drawing.warnings[1].reason.find("second border"), std::string::npos);
}

}  // namespace
}  // namespace strandline
