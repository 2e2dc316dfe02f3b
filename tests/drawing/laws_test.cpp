// Laws: a drawing that is turned, mirrored, moved or scaled is the same drawing.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "drawing/shapes.hpp"

namespace strandline {
namespace {

double uniform(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1 << 20) / (1 << 20);
}
Point point() { return {uniform(-50, 150), uniform(-50, 150)}; }

/// Lines, curves, rings and stars of every paint, some of them in pieces that meet.
std::vector<svg::Shape> random_shapes() {
    std::vector<svg::Shape> shapes{stroked(line({{0, 0}, {100, 80}}))};
    const int count = *rc::gen::inRange(1, 12);
    for (int i = 0; i < count; ++i) {
        const Point at = point();
        switch (*rc::gen::inRange(0, 5)) {
            case 0:
                shapes.push_back(stroked(line({at, point(), point()})));
                break;
            case 1: {
                // Outlines that touch in a point may be one region or two: rounding decides. These do not.
                const double radius = uniform(1, 30), side = radius * uniform(0.1, 1.2);
                shapes.push_back(filled({circle(at, radius), square(at - Point{side / 2, side / 2}, side)},
                                        svg::FillRule::even_odd));
                break;
            }
            case 2:
                shapes.push_back(shape({square(at, uniform(2, 40))}, black, red, uniform(0.5, 4)));
                break;
            case 3: {
                const Point middle = point();
                shapes.push_back(stroked(line({at, middle})));
                shapes.push_back(stroked(Path{point(), {CubicSegment{point(), point(), middle}}, false}));
                break;
            }
            default:
                shapes.push_back(stroked(circle(at, uniform(1, 30)), uniform(0.2, 8)));
        }
    }
    return shapes;
}

double total_area(const Drawing& drawing) {
    double sum = 0;
    for (std::size_t i = 0; i < drawing.elements.size(); ++i)
        if (is_region(drawing.elements[i])) sum += area(region_of(drawing, i));
    return sum;
}
double total_length(const Drawing& drawing) {
    double sum = 0;
    for (const Element& element : drawing.elements)
        if (!is_region(element)) sum += length(element);
    return sum;
}
void expect_same(const Drawing& a, const Drawing& b, double factor) {
    RC_ASSERT(ids(a) == ids(b));
    RC_ASSERT(insides(a) == insides(b));
    RC_ASSERT(a.counts == b.counts);
    RC_ASSERT(std::abs(total_length(a) * factor - total_length(b)) < 1e-6 * (1 + total_length(b)));
    double outlines = 0;
    for (const Element& element : b.elements) outlines += is_region(element) ? length(element) : 0;
    RC_ASSERT(std::abs(total_area(a) * factor * factor - total_area(b)) <= 0.004 * outlines + 1e-3);
}

TEST(DrawingLaws, TurnedAndMirroredItKeepsItsLengthsAreasAndNesting) {
    EXPECT_TRUE(rc::check([] {
        const auto shapes = random_shapes();
        DrawingOptions options = metre_a_unit();
        options.occlusion = false;  // where lines are cut is known to the tolerance, not to rounding
        const Drawing plain = drawn(shapes, options);
        options.rotate = uniform(0, 2 * pi);
        options.mirror = *rc::gen::arbitrary<bool>();
        options.position = point();
        expect_same(plain, drawn(shapes, options), 1);
    }));
}

TEST(DrawingLaws, ScaledWithItsTolerancesItScales) {
    EXPECT_TRUE(rc::check([] {
        const auto shapes = random_shapes();
        const double factor = uniform(0.1, 3);
        DrawingOptions options = metre_a_unit();
        options.occlusion = false;  // where lines are cut is known to the tolerance, not to rounding
        const Drawing plain = drawn(shapes, options);
        options.scale_denominator /= factor;
        for (double* metres : {&options.tolerance, &options.join_tolerance, &options.min_length})
            *metres *= factor;
        Robot robot = beachbot();
        robot.pin_pitch *= factor;
        Drawing scaled = drawn(shapes, options, robot);
        expect_same(plain, scaled, factor);
    }));
}

TEST(DrawingLaws, FitLeavesTheMarginFreeAndTouchesIt) {
    EXPECT_TRUE(rc::check([] {
        const auto shapes = random_shapes();
        DrawingOptions options;
        options.canvas = {uniform(3, 60), uniform(3, 60)};
        options.margin = uniform(0, 1.4);
        options.rotate = uniform(0, 2 * pi);
        options.mirror = *rc::gen::arbitrary<bool>();
        const Drawing d = drawn(shapes, options);
        const Box box = bounds(d), room = grown({{0, 0}, {options.canvas.width, options.canvas.height}},
                                                1e-6 - options.margin);
        RC_ASSERT(contains(room, box.low));
        RC_ASSERT(contains(room, box.high));
        RC_ASSERT(d.warnings.empty());
    }));
}

TEST(DrawingLaws, EveryElementLiesWhereTheMapPutsTheFile) {
    EXPECT_TRUE(rc::check([] {
        const auto shapes = random_shapes();
        DrawingOptions options;
        options.rotate = uniform(0, 2 * pi);
        options.occlusion = false;  // the diagonal line is whole
        const Drawing d = drawn(shapes, options);
        RC_ASSERT(std::abs(mean_scale(d.to_canvas) - d.scale) < 1e-9 * d.scale);
        // The diagonal line is there in every drawing and may only have been joined at its ends.
        Point a = apply(d.to_canvas, {0, 0}), b = apply(d.to_canvas, {100, 80});
        RC_ASSERT(std::abs(distance(a, b) - d.scale * std::sqrt(16400)) < 1e-9);
        for (const double share : {0.25, 0.5, 0.75})
            RC_ASSERT(distance_to(flattened(line_of(d, 0).path, 1e-3), between(a, b, share)) < 2e-3);
    }));
}

TEST(DrawingLaws, TheSameInputIsTheSameDrawing) {
    EXPECT_TRUE(rc::check([] {
        const auto shapes = random_shapes();
        RC_ASSERT(drawn(shapes) == drawn(shapes));
    }));
}

TEST(DrawingLaws, ParentsAreLargerOrEarlierSoNobodyIsInsideHimself) {
    EXPECT_TRUE(rc::check([] {
        const Drawing d = drawn(random_shapes());
        for (std::size_t i = 0; i < d.elements.size(); ++i) {
            int steps = 0;
            for (int at = d.elements[i].inside; at >= 0; at = d.elements[static_cast<std::size_t>(at)].inside)
                RC_ASSERT(++steps <= static_cast<int>(d.elements.size()));
        }
    }));
}

}  // namespace
}  // namespace strandline
