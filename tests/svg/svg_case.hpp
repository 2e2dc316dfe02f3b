#pragma once
// Small helpers of this room's tests.
#include <gtest/gtest.h>

#include <string>

#include "input/svg/svg.hpp"

namespace strandline::svg {

/// The document of a text that must be read.
inline Document read_well(const std::string& text) {
    auto document = read(text);
    if (!document) {
        ADD_FAILURE() << sentence(document.error()) << "\n" << text;
        return {};
    }
    return *document;
}
/// The document of elements inside a plain 100 x 100 root.
inline Document drawn(const std::string& elements) {
    return read_well("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + elements + "</svg>");
}
/// The first shape of it.
inline Shape first_shape(const std::string& elements) {
    const auto document = drawn(elements);
    if (document.shapes.empty()) {
        ADD_FAILURE() << "nothing drawn: " << elements;
        return {};
    }
    return document.shapes.front();
}
inline std::string all_warnings(const Document& document) {
    std::string text;
    for (const auto& warning : document.warnings) text += sentence(warning) + "\n";
    return text;
}
inline bool warns_of(const Document& document, const std::string& phrase) {
    return all_warnings(document).find(phrase) != std::string::npos;
}
inline Error refusal(const std::string& text) {
    const auto document = read(text);
    EXPECT_FALSE(document) << text;
    return document ? Error{} : document.error();
}
inline void expect_near(Point a, Point b, double tolerance = 1e-12) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}
inline Point at(const ArcSegment& arc, double t) {
    return arc.center + std::cos(t) * arc.u + std::sin(t) * arc.v;
}

}  // namespace strandline::svg
