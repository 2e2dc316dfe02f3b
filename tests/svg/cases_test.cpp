// Hand-written files (tests/svg/cases), many in the idioms of drawing programs, with what must come out.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "math/region/region.hpp"
#include "svg_case.hpp"

namespace strandline::svg {
namespace {

/// What a file shows, worked out by hand. User units.
struct Case {
    const char* name;
    std::size_t shapes;
    Box box;                        ///< of all outlines and lines
    double area;                    ///< of the fills, added up
    double lines;                   ///< length of the strokes, added up
    const char* warning = nullptr;  ///< one that must be there; otherwise there is none
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

const double circle_cut =
    400 * pi - (400 * std::acos(0.5) - 10 * std::sqrt(300));  // r 20, cut 10 off its centre

const std::vector<Case>& cases() {
    static const std::vector<Case> table{
        {"illustrator-classes", 3, {{10, 10}, {150, 60}}, 1200, 40 + 80},
        {"illustrator-minified", 2, {{0, 0}, {50, 50}}, 2500 + 800, 0},
        {"illustrator-clip-use", 2, {{20, 20}, {45, 50}}, 600, 30},
        {"illustrator-entities-switch", 1, {{6, 6}, {66, 66}}, 3600, 240, "<switch>"},
        {"illustrator-hidden-layer", 1, {{40, 40}, {60, 60}}, 100 * pi, 0, "hidden (display: none)"},
        {"illustrator-symbols", 2, {{0, 0}, {60, 60}}, 200 + 800, 0},
        {"illustrator-dashes-gradient", 2, {{0, 0}, {100, 50}}, 2000, 60},
        {"affinity-matrix-evenodd", 1, {{40, 40}, {160, 160}}, 16 * 800, 0},
        {"affinity-clip", 1, {{20, 20}, {120, 60}}, 4 * (50 * 20 - 30 * 10), 0},
        {"affinity-strokes", 2, {{50, 100}, {250, 250}}, 0, 100 + 100 * pi, "neither filled nor stroked"},
        {"affinity-image-and-hidden",
         1,
         {{0, 300}, {400, 400}},
         40'000,
         0,
         "<use> of an element that draws nothing"},
        {"figma-clip-frame", 3, {{0, 0}, {120, 80}}, 9600 + circle_cut, 40},
        {"figma-mask-icon", 1, {{4, 4}, {24, 8}}, 80, 0},
        {"figma-inside-stroke", 2, {{10, 10}, {90, 90}}, 6400, 320, "wholly outside its clip"},
        {"figma-opacity-rotate", 3, {{0, 10}, {190, 90.5}}, 800, 40 + 20 + 40 + 20 + 19 * pi + 100},
        {"figma-filter-gradient", 2, {{0, 0}, {50, 50}}, 1700, 0, "filter is not supported"},
        {"inkscape-layers-mm", 1, {{10, 20}, {60, 60}}, 2000, 0, "hidden (display: none)"},
        {"inkscape-clone", 6, {{10, 10}, {80, 95}}, 3 * 400, 3 * 10 * pi},
        {"inkscape-arrow", 2, {{20, 47}, {64, 53}}, 18, 40},
        {"inkscape-clip-objects", 1, {{50, 30}, {70, 70}}, 200 * pi, 0},
        {"percent-lengths", 2, {{40, 30}, {240, 185.35533905932738}}, 200 * 150, 2 * pi * 35.35533905932738},
        {"units", 3, {{0, 0}, {288, 96}}, 3 * 96 * 96, 0},
        {"em-and-font-size", 1, {{0, 0}, {40, 10}}, 400, 0},
        {"nested-svg", 2, {{20, 20}, {70, 70}}, 625 + 625, 0},
        {"nested-svg-slice", 1, {{0, 0}, {40, 20}}, 800, 0},
        {"symbol-sizes", 2, {{0, 0}, {70, 60}}, 40 * 20 + 20 * 10, 0},
        {"switch-language", 1, {{0, 0}, {20, 10}}, 200, 0, "<switch>"},
        {"anchor-and-title", 1, {{0, 0}, {20, 10}}, 200, 0},
        {"current-color", 2, {{0, 0}, {30, 50}}, 200, 30},
        {"css-important", 1, {{0, 0}, {20, 10}}, 200, 0, "neither filled nor stroked"},
        {"css-descendants", 3, {{0, 0}, {50, 10}}, 50, 20 + 10},
        {"fill-rules", 2, {{0, 0}, {70, 30}}, 900 + 800, 0},
        {"no-ink", 1, {{0, 0}, {20, 10}}, 200, 0, "neither filled nor stroked"},
        {"stroke-widths", 2, {{0, 20}, {20, 20}}, 0, 40},
        {"dashes-path-length", 1, {{20, 20}, {80, 80}}, 0, 0.4 * 60 * pi},
        {"dashes-with-fill", 1, {{10, 10}, {50, 30}}, 800, 60},
        {"clip-bounding-box", 1, {{10, 10}, {90, 50}}, 800 * pi, 0},
        {"clip-nested", 2, {{30, 20}, {60, 50}}, 900, 30},
        {"clip-of-two-and-a-hole", 1, {{0, 0}, {80, 40}}, 1200 + 400, 0},
        {"mask-cut-out", 1, {{0, 0}, {60, 60}}, 3600 - 400, 0},
        {"transforms", 2, {{5, 5}, {50, 90}}, 400 + 400, 0},
        {"use-styles", 2, {{0, 0}, {20, 20}}, 0, 40},
        {"arcs", 2, {{10, 10}, {90, 70}}, 800 * pi, 48.44224110273838},
        {"latin-1-names", 1, {{0, 0}, {20, 10}}, 200, 0},
        {"no-namespace", 1, {{0, 0}, {20, 10}}, 200, 0},
    };
    return table;
}

const std::filesystem::path folder = std::string(STRANDLINE_SOURCE) + "/tests/svg/cases";

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {(std::istreambuf_iterator<char>(file)), {}};
}

double filled(const Shape& shape) {
    std::vector<Polygon> polygons;
    for (const auto& path : shape.subpaths) polygons.push_back(flattened(path, 1e-4));
    return area(resolved(polygons, shape.fill_rule == FillRule::even_odd ? strandline::FillRule::even_odd
                                                                         : strandline::FillRule::nonzero));
}

class Cases : public ::testing::TestWithParam<Case> {};

TEST_P(Cases, ShowsWhatItsProgramShows) {
    const auto& expected = GetParam();
    const auto document = read_well(text_of(folder / (std::string(expected.name) + ".svg")));
    EXPECT_EQ(document.shapes.size(), expected.shapes);
    Box box;
    double area = 0, lines = 0;
    for (const auto& shape : document.shapes) {
        if (shape.fill) {
            area += filled(shape);
            for (const auto& path : shape.subpaths) box = united(box, bounds(path));
        }
        if (shape.stroke)
            for (const auto& path : stroked_paths(shape)) {
                lines += length(path);
                box = united(box, bounds(path));
            }
    }
    const double size = distance(expected.box.low, expected.box.high);
    expect_near(box.low, expected.box.low, 1e-4 * size);
    expect_near(box.high, expected.box.high, 1e-4 * size);
    EXPECT_NEAR(area, expected.area, 2e-4 * size * size);
    EXPECT_NEAR(lines, expected.lines, 1e-4 * size);
    if (expected.warning != nullptr)
        EXPECT_TRUE(warns_of(document, expected.warning)) << all_warnings(document);
    else
        EXPECT_TRUE(document.warnings.empty()) << all_warnings(document);
}

INSTANTIATE_TEST_SUITE_P(Files, Cases, ::testing::ValuesIn(cases()), [](const auto& one) {
    std::string name = one.param.name;
    std::erase(name, '-');
    return name;
});

TEST(CaseFiles, EveryFileHasItsExpectation) {
    std::set<std::string> files, expected;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.insert(entry.path().stem().string());
    for (const auto& one : cases()) expected.insert(one.name);
    EXPECT_EQ(files, expected);
    EXPECT_GE(files.size(), 40u);
}

}  // namespace
}  // namespace strandline::svg
