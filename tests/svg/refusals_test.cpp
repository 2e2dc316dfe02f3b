// Bad input: one clear error each, and the law that any bytes give a document or one error.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "contract.hpp"
#include "svg_case.hpp"

namespace strandline::svg {
namespace {

TEST(Refusals, WhatIsNoSvgIsNamed) {
    EXPECT_EQ(refusal("").reason, "the file is empty");
    EXPECT_EQ(refusal(" \n\t ").reason, "the file is empty");
    EXPECT_EQ(refusal("\n  hello").place, "line 2:3");
    EXPECT_EQ(refusal("hello").reason, "not XML: the first character is not '<'");
    EXPECT_EQ(refusal("\x1F\x8B\x08").reason, "a compressed SVG (.svgz)");
    EXPECT_EQ(refusal("<!-- nothing -->").reason, "not well-formed XML: no element in it: not an SVG");
    EXPECT_EQ(sentence(refusal("\n<html/>")),
              "line 2, <html>: the outermost element is not <svg>; give an SVG file");
    EXPECT_EQ(refusal(std::string("<svg>\n\0</svg>", 13)).place, "line 2:1");
}

TEST(Refusals, TruncatedXmlIsNamedWithLineAndColumn) {
    EXPECT_EQ(refusal("<svg>\n <g>\n  <path d='M0 0").place, "line 3:12");
    EXPECT_EQ(refusal("<svg>\n <g>\n  <path d='M0 0").reason,
              "not well-formed XML: the file ends inside an attribute");
    EXPECT_EQ(refusal("<svg><g>").reason,
              "not well-formed XML: the file ends before its elements are closed");
    EXPECT_EQ(refusal("<svg>\n<g></p></svg>").place.substr(0, 7), "line 2:");
}

TEST(Refusals, EveryProperBeginningOfAFileIsRefused) {
    const std::string text =
        "<?xml version='1.0'?>\n<svg viewBox='0 0 9 9'>\n<g fill='red'><path d='M0 0h1'/><!-- c "
        "--></g>\n</svg>";
    for (std::size_t n = 0; n < text.size(); ++n) {
        const auto error = refusal(text.substr(0, n));
        EXPECT_FALSE(error.reason.empty() || error.remedy.empty()) << text.substr(0, n);
    }
    EXPECT_TRUE(read(text));
}

TEST(Refusals, EntityBombsAreRefusedBeforeTheyGrow) {
    std::string bomb = "<!DOCTYPE svg [<!ENTITY a0 'lol'>", hollow = "<!DOCTYPE svg [<!ENTITY a0 ''>";
    for (int i = 1; i < 20; ++i) {
        const std::string name = "<!ENTITY a" + std::to_string(i) + " '";
        for (auto* text : {&bomb, &hollow}) {
            *text += name;
            for (int k = 0; k < 10; ++k) *text += "&a" + std::to_string(i - 1) + ";";
            *text += "'>";
        }
    }
    EXPECT_EQ(refusal(bomb + "]><svg>&a19;</svg>").place, "line 1, <!DOCTYPE>");
    EXPECT_NE(refusal(hollow + "]><svg id='&a19;'/>").reason.find("grows beyond 100000"), std::string::npos);
    EXPECT_NE(
        refusal("<!DOCTYPE svg [<!ENTITY a '&b;'><!ENTITY b '&a;'>]><svg/>").reason.find("names itself"),
        std::string::npos);
    std::string wide = "<!DOCTYPE svg [<!ENTITY a '" + std::string(90'000, 'x') + "'>]><svg>";
    for (int i = 0; i < 1000; ++i) wide += "<g id='&a;'/>";
    EXPECT_NE(refusal(wide + "</svg>").reason.find("entities grow the file"), std::string::npos);
}

TEST(Refusals, NumbersThatAreNotFiniteOrTooLargeAreRefusedWithTheirPlace) {
    for (const char* element :
         {"<path id='x' d='M0 0L1e308 1'/>", "<path id='x' d='M0 0 nan 1'/>", "<path id='x' d='M0 0h-inf'/>",
          "<path id='x' d='m9e14 0h9e14'/>", "<rect id='x' width='1e16' height='1'/>",
          "<circle id='x' r='inf'/>", "<polygon id='x' points='0 0 1 NaN 2 2'/>",
          "<path id='x' transform='scale(1e300)' d='M0 0h1'/>",
          "<g id='x' transform='scale(1e9) scale(1e9)'/>",
          "<path id='x' stroke='red' stroke-width='1e99' d='M0 0h1'/>",
          "<path id='x' transform='scale(1e14)' d='M0 0h100'/>"}) {
        const auto error = refusal("<svg>\n" + std::string(element) + "</svg>");
        EXPECT_EQ(error.place.substr(0, 8), "line 2, ") << element;
        EXPECT_NE(error.place.find("#x"), std::string::npos) << element;
        EXPECT_NE(error.reason.find("not finite or beyond 1e+15"), std::string::npos) << error.reason;
    }
    EXPECT_EQ(refusal("<svg viewBox='0 0 1e308 1'/>").place, "line 1, <svg>");
    EXPECT_EQ(refusal("<svg width='inf'/>").place, "line 1, <svg>");
}

TEST(Refusals, LimitsAreKept) {
    const std::string text = "<svg><g><g><path d='M0 0h1h1h1'/></g></g></svg>";
    EXPECT_TRUE(read(text, {.limits = {.depth = 4, .elements = 4, .segments = 3}}));
    EXPECT_EQ(read(text, {.limits = {.depth = 3}}).error().reason, "elements are nested deeper than 3");
    EXPECT_EQ(read(text, {.limits = {.elements = 3}}).error().reason, "more than 3 elements in the file");
    EXPECT_EQ(read(text, {.limits = {.segments = 2}}).error().reason,
              "more than 2 path segments in the file");
    EXPECT_FALSE(read("<svg><rect width='1' height='1'/></svg>", {.limits = {.segments = 2}}));
    EXPECT_FALSE(read(text, {.limits = {.bytes = 10}}));
}

TEST(Refusals, ManyThousandLevelsAreRefusedNotACrash) {
    std::string deep = "<svg>";
    for (int i = 0; i < 100'000; ++i) deep += "<g>";
    for (int i = 0; i < 100'000; ++i) deep += "</g>";
    EXPECT_EQ(refusal(deep + "</svg>").reason, "elements are nested deeper than 512");
}

TEST(Refusals, StoppingKeepsWhatWasRead) {
    const auto document = read("<svg><path d='M0 0h1'/></svg>", {}, {.stopped = [] { return true; }});
    ASSERT_TRUE(document);
    EXPECT_TRUE(warns_of(*document, "stopped here"));
}

/// A document that keeps its contract, or an error that says something.
void expect_answer(const std::string& bytes) {
    const auto document = read(bytes);
    if (document)
        EXPECT_TRUE(keeps_contract(*document)) << bytes;
    else
        EXPECT_FALSE(document.error().reason.empty()) << bytes;
}

const std::string rich = R"SVG(<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY c "fill:red">]>
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 90 90" width="9cm" height="9cm" rake_sizes="0 1 3">
<defs><linearGradient id="g" href="#h"><stop offset="0" stop-color="#123"/></linearGradient></defs>
<g transform="translate(1,2) rotate(30 4 5) skewX(3)" style="&c;;stroke:rgb(10%,20%,30%);stroke-width:2mm" opacity=".5">
<path id="p" d="M1 2c.5-.5 1e1 2 3 4s5 6 7 8q1 2 3 4t5 6a5 3 20 0110 10zm3 4h5v-6L1 1z"/>
<rect x="1" y="2" width="30%" height="4em" rx="1"/><circle cx="4" r="5"/><ellipse rx="3" ry="4" fill="url(#g) none"/>
<polyline points="1,2 3,4 5-6"/><polygon points="1 2 3 4 5 6"/><line x1="3" y2="4"/></g>
<svg x="1" width="20" height="30" viewBox="0 0 3 4"><switch><g/></switch></svg><text>&#233;&lt;</text><use/></svg>)SVG";

/// Bytes changed, taken out, doubled, and pieces of the grammar put in.
std::string mutated(std::string text, std::mt19937_64& random) {
    static const std::vector<std::string> tokens{"nan",     "1e999",   "-",    "\"",   "<",
                                                 "/>",      "<g>",     "</g>", "&",    ";",
                                                 "url(#g)", "(",       ")",    "%",    "\xFF",
                                                 "<!--",    "]]>",     "e9",   "#",    "M",
                                                 "a",       "z",       ",",    "1e15", std::string(1, '\0'),
                                                 "<svg ",   "xmlns=''"};
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    for (std::size_t edits = 1 + below(4); edits > 0 && !text.empty(); --edits) {
        const auto at_byte = below(text.size());
        switch (below(4)) {
            case 0:
                text[at_byte] = static_cast<char>(random() & 255);
                break;
            case 1:
                text.erase(at_byte, 1 + below(12));
                break;
            case 2:
                text.insert(at_byte, text.substr(below(text.size()), below(40)));
                break;
            default:
                text.insert(at_byte, tokens[below(tokens.size())]);
                break;
        }
    }
    return text;
}

TEST(Law, AnyBytesGiveADocumentOrOneError) {
    std::mt19937_64 random(2);
    ASSERT_TRUE(read(rich)) << sentence(read(rich).error());
    for (int i = 0; i < 4000; ++i) expect_answer(mutated(rich, random));
    for (int i = 0; i < 500; ++i) {
        std::string noise(random() % 200, ' ');
        for (char& c : noise) c = static_cast<char>(random() & 255);
        expect_answer(noise);
        expect_answer("<svg>" + noise + "</svg>");
        EXPECT_LE(parse_path_data("M0 0" + noise).subpaths.size(), noise.size() + 1);
    }
}

TEST(Law, RealDrawingsAreReadAndSurviveMutation) {
    const std::filesystem::path folder = std::string(STRANDLINE_SHARED) + "/drawings";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no ../shared here";
    std::mt19937_64 random(3);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        const auto document = read_well(text);
        EXPECT_FALSE(document.shapes.empty()) << entry.path();
        EXPECT_TRUE(keeps_contract(document)) << entry.path();
        if (text.size() < 50'000)
            for (int i = 0; i < 50; ++i) expect_answer(mutated(text, random));
    }
}

}  // namespace
}  // namespace strandline::svg
