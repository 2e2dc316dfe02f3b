#include <gtest/gtest.h>

#include "svg_case.hpp"

namespace strandline::svg {
namespace {

const std::string shape = "<path d='M1 2H5V9'/>";
Document page(const std::string& attributes) {
    return read_well("<svg " + attributes + ">" + shape + "</svg>");
}
void expect_size(const std::string& attributes, double width, double height) {
    const auto size = page(attributes).size_metres;
    ASSERT_TRUE(size) << attributes;
    EXPECT_NEAR(size->x, width, 1e-12) << attributes;
    EXPECT_NEAR(size->y, height, 1e-12) << attributes;
}

TEST(Page, TheViewIsTheViewBoxElseTheSizeElseTheShapes) {
    EXPECT_EQ(page("viewBox='-1,-2 30 40' width='9' height='9'").view, (Box{{-1, -2}, {29, 38}}));
    EXPECT_EQ(page("width='1in' height='50'").view, (Box{{0, 0}, {96, 50}}));
    EXPECT_EQ(page("").view, (Box{{1, 2}, {5, 9}}));
    EXPECT_EQ(page("width='100%' height='100%'").view, (Box{{1, 2}, {5, 9}}));
}

TEST(Page, TheSizeIsMetresWhereTheFileHasOne) {
    expect_size("width='210mm' height='297mm'", 0.21, 0.297);
    expect_size("width='96' height='192px' viewBox='0 0 1 1'", 0.0254, 0.0508);
    expect_size("width='72pt' height='6pc'", 0.0254, 0.0254);
    expect_size("width='10cm' viewBox='0 0 2 1'", 0.1, 0.05);
    for (const char* attributes : {"", "viewBox='0 0 1 1'", "width='100%' height='5' ", "width='5'"})
        EXPECT_FALSE(page(attributes).size_metres) << attributes;
}

TEST(Page, DegenerateSizesCountAsAbsent) {
    for (const char* attributes :
         {"viewBox='0 0 0 5'", "viewBox='0 0 5'", "viewBox='a b'", "width='0' height='-3'", "width='wide'"}) {
        const auto document = page(attributes);
        EXPECT_EQ(document.view, (Box{{1, 2}, {5, 9}})) << attributes;
        EXPECT_TRUE(warns_of(document, "passed over")) << attributes;
    }
}

TEST(Page, RakeSizesAreRead) {
    EXPECT_EQ(page("rake_sizes='0 1, 3 5 8'").rake_sizes, (std::vector<double>{0, 1, 3, 5, 8}));
    EXPECT_TRUE(warns_of(page("rake_sizes='thin'"), "rake_sizes is not a list of numbers"));
}

TEST(Names, FilesWithoutOrWithPrefixedOrMisspeltNamespaceAreRead) {
    for (const char* text : {"<svg>@</svg>", "<svg xmlns='http://www.w3.org/2000/svg'>@</svg>",
                             "<svg xmlns='http://www.w3.org/2000/SVG/'>@</svg>"}) {
        std::string file = text;
        file.replace(file.find('@'), 1, shape);
        EXPECT_EQ(read_well(file).shapes.size(), 1u) << text;
    }
    EXPECT_EQ(read_well("<svg:svg><svg:path d='M0 0h1'/></svg:svg>").shapes.size(), 1u);
    EXPECT_EQ(read_well("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:g><s:path d='M0 0h1'/></s:g></s:svg>")
                  .shapes.size(),
              1u);
}

TEST(Names, ElementsOfOtherLanguagesAreNotDrawn) {
    const auto document = drawn(
        "<x:path xmlns:x='urn:x' d='M0 0h1'/><g xmlns='urn:x'><path d='M0 0h1'/></g>"
        "<metadata><path d='M0 0h1'/></metadata><sodipodi:namedview/>");
    EXPECT_TRUE(document.shapes.empty());
    EXPECT_TRUE(document.warnings.empty()) << all_warnings(document);
}

TEST(Names, IdsAreUniqueAndPlacesCountLines) {
    const auto document =
        drawn("\n<path id='eye' d='M0 0h1'/>\n  <path d='M0 0h1'/><path id='eye' d='M0 0h1'/>");
    ASSERT_EQ(document.shapes.size(), 3u);
    EXPECT_EQ(document.shapes[0].id, "eye");
    EXPECT_EQ(document.shapes[0].place, "line 2, <path> #eye");
    EXPECT_EQ(document.shapes[1].id, "path@3:3");
    EXPECT_EQ(document.shapes[2].id, "eye@3:21");
    EXPECT_EQ(document.shapes[2].line, 3);
}

TEST(Names, LayersNestByTheirLabels) {
    const auto document =
        drawn("<g inkscape:groupmode='layer' inkscape:label='Sea'><g><g inkscape:groupmode='layer' id='l2'>" +
              shape + "</g></g>" + shape + "</g>" + shape);
    ASSERT_EQ(document.shapes.size(), 3u);
    EXPECT_EQ(document.shapes[0].layer, "Sea/l2");
    EXPECT_EQ(document.shapes[1].layer, "Sea");
    EXPECT_EQ(document.shapes[2].layer, "");
}

TEST(Names, WhatOnlyDefinesIsNotDrawn) {
    for (const char* name : {"defs", "symbol", "clipPath", "mask", "marker", "pattern", "metadata", "title"})
        EXPECT_TRUE(drawn("<" + std::string(name) + ">" + shape + "</" + name + ">").shapes.empty()) << name;
}

TEST(LeftOut, EveryKindIsOneWarningWithItsFirstPlaceAndCount) {
    std::string images;
    for (int i = 0; i < 10'000; ++i) images += "<image/>\n";
    const auto document = drawn("\n" + images + "<text id='t'>hello</text><foreignObject/><blob/>");
    EXPECT_EQ(document.warnings.size(), 4u) << all_warnings(document);
    EXPECT_TRUE(
        warns_of(document, "line 2, <image>: images are not drawn: left out (10000 times, first here)"));
    EXPECT_TRUE(warns_of(document, "line 10002, <text> #t: text is left out (turn it into paths)"));
    EXPECT_TRUE(warns_of(document, "an element that SVG does not know: left out: blob"));
}

TEST(LeftOut, PropertiesThatChangeTheDrawingAreSaid) {
    for (const char* attribute :
         {"clip-path='url(#a)'", "mask='url(#a)'", "filter='url(#a)'", "marker-end='url(#a)'",
          "style='transform-box:fill-box'", "clip-path='url(other.svg#a)'"})
        EXPECT_EQ(drawn("<path d='M0 0h1' " + std::string(attribute) + "/>").warnings.size(), 1u)
            << attribute;
    EXPECT_TRUE(drawn("<path d='M0 0h1' clip-path='none' marker-end='none' stroke-dasharray='none'/>")
                    .warnings.empty());
}

TEST(LeftOut, ASwitchDrawsItsFirstFittingChild) {
    const auto document =
        drawn("<switch><foreignObject requiredExtensions='x'/><title/><g systemLanguage='de'>" + shape +
              "</g><g id='en'>" + shape + shape + "</g><g>" + shape + "</g></switch>");
    EXPECT_EQ(document.shapes.size(), 2u);
    EXPECT_TRUE(warns_of(document, "<switch>: its first fitting child is drawn"));
}

TEST(LeftOut, BadPathDataIsKeptUpToItsErrorWithItsPlace) {
    const auto document = drawn("\n<path id='p' d='M0 0L1 1L2 x'/>");
    ASSERT_EQ(document.shapes.size(), 1u);
    EXPECT_TRUE(warns_of(
        document, "line 2, <path> #p: a faulty outline: kept up to its fault: a number expected, 'x' found"));
}

TEST(Entities, IllustratorsNamespacesAndStylesArePutIn) {
    const auto document = read_well(
        "<!DOCTYPE svg PUBLIC 'a' 'b' [\n<!-- <!ENTITY no \"x\"> -->\n<!ENTITY ns_svg "
        "\"http://www.w3.org/2000/svg\">\n"
        "<!ENTITY ink 'blue'><!ENTITY st0 'fill:&ink;'>\n]>\n"
        "<s:svg xmlns:s='&ns_svg;'><s:path style='&st0;' d='M0 0h1v1z'/></s:svg>");
    ASSERT_EQ(document.shapes.size(), 1u);
    EXPECT_EQ(document.shapes[0].fill->colour, (Colour{0, 0, 255}));
    EXPECT_EQ(document.shapes[0].line, 6);
}

TEST(Entities, MayHoldElementsAndQuotesAndKeepTheLines) {
    const auto document = read_well(
        "<!DOCTYPE svg [\n<!ENTITY eye '<circle id=\"eye\" r=\"2\"\n/>'><!ENTITY font \"'A', \"><!ENTITY "
        "less '<'>\n]>\n<svg><!-- &eye; --><desc>&less;a/></desc><g>&eye;</g>\n"
        "<path style='font-family:&font;serif;fill:red' d='M0 0h1v1z'/></svg>");
    ASSERT_EQ(document.shapes.size(), 2u) << all_warnings(document);
    EXPECT_EQ(document.shapes[0].id, "eye");
    EXPECT_EQ(document.shapes[1].line, 6);
    EXPECT_EQ(document.shapes[1].fill->colour, (Colour{255, 0, 0}));
}

TEST(Encodings, Utf16Latin1AndAMarkAreRead) {
    const std::string text = "<svg><path id='\xC3\xA9' d='M0 0h1'/></svg>";
    EXPECT_EQ(read_well("\xEF\xBB\xBF" + text).shapes.at(0).id, "\xC3\xA9");
    EXPECT_EQ(read_well("<?xml version='1.0' encoding='ISO-8859-1'?><svg><path id='\xE9' d='M0 0h1'/></svg>")
                  .shapes.at(0)
                  .id,
              "\xC3\xA9");
    const std::u16string wide = u"<svg><path id='\u00E9\U0001F60A' d='M0 0h1'/></svg>";
    for (const bool big : {false, true})
        for (const bool mark : {false, true}) {
            std::string bytes;
            for (const char16_t c : (mark ? u"\uFEFF" : u"") + wide) {
                const char high = static_cast<char>(c >> 8), low = static_cast<char>(c & 255);
                bytes += big ? high : low;
                bytes += big ? low : high;
            }
            EXPECT_EQ(read_well(bytes).shapes.at(0).id, "\xC3\xA9\xF0\x9F\x98\x8A");
        }
}

}  // namespace
}  // namespace strandline::svg
