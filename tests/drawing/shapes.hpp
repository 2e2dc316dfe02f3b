#pragma once
// Documents made by hand, in user units with y down, as the reader makes them.
#include <string>
#include <utility>
#include <vector>

#include "input/drawing/drawing.hpp"

namespace strandline {

inline constexpr svg::Paint black{{0, 0, 0}, 1}, white{{255, 255, 255}, 1}, red{{255, 0, 0}, 1},
    start_green{{0, 255, 0}, 1};

inline Path square(Point corner, double side) {
    return path_through(
        {corner, corner + Point{side, 0}, corner + Point{side, side}, corner + Point{0, side}}, true);
}
inline Path circle(Point center, double radius) {
    const Point start = center + Point{radius, 0};
    return {start, {ArcSegment{center, {radius, 0}, {0, radius}, 0, 2 * pi, start}}, true};
}
inline Path line(std::vector<Point> points) { return path_through(points, false); }

inline svg::Shape shape(std::vector<Path> paths, std::optional<svg::Paint> fill,
                        std::optional<svg::Paint> stroke, double width = 0.3) {
    svg::Shape s;
    s.subpaths = std::move(paths);
    s.fill = fill;
    s.stroke = stroke;
    s.stroke_width = width;
    return s;
}
inline svg::Shape stroked(Path path, double width = 0.3) {
    return shape({std::move(path)}, {}, black, width);
}
inline svg::Shape filled(std::vector<Path> paths, svg::FillRule rule = svg::FillRule::nonzero) {
    svg::Shape s = shape(std::move(paths), black, {});
    s.fill_rule = rule;
    return s;
}

/// A page of 100 x 100 user units and 0.1 x 0.1 m; shapes without id are a, b, c ...
inline svg::Document document(std::vector<svg::Shape> shapes) {
    svg::Document d;
    d.view = {{0, 0}, {100, 100}};
    d.size_metres = Point{0.1, 0.1};
    d.shapes = std::move(shapes);
    char letter = 'a';
    for (svg::Shape& s : d.shapes) {
        if (s.id.empty()) s.id = std::string(1, letter);
        s.place = "<path> #" + s.id;
        ++letter;
    }
    return d;
}

/// The beach robot of the headers, with the rules of 2014.
inline Robot beachbot() {
    Robot robot;
    robot.rake_rules = {{0, 0}, {1, 1}, {3, 3}, {5, 5}, {8, 7}};
    return robot;
}

/// A metre a user unit, user origin at the canvas's: the numbers of the file are the numbers on the ground, y
/// turned up.
inline DrawingOptions metre_a_unit() {
    DrawingOptions options;
    options.canvas = {100, 100};
    options.place = Place::scale;
    options.scale_denominator = 0.001;
    return options;
}

inline Drawing drawn(std::vector<svg::Shape> shapes, const DrawingOptions& options = metre_a_unit(),
                     const Robot& robot = beachbot()) {
    auto drawing = make_drawing(document(std::move(shapes)), robot, options);
    if (!drawing) throw std::runtime_error(sentence(drawing.error()));
    return *drawing;
}
inline const Region& region_of(const Drawing& drawing, std::size_t i) {
    return std::get<RegionElement>(drawing.elements.at(i).what).region;
}
inline const LineElement& line_of(const Drawing& drawing, std::size_t i) {
    return std::get<LineElement>(drawing.elements.at(i).what);
}
inline std::vector<std::string> ids(const Drawing& drawing) {
    std::vector<std::string> all;
    for (const Element& element : drawing.elements) all.push_back(element.id);
    return all;
}
inline std::vector<int> insides(const Drawing& drawing) {
    std::vector<int> all;
    for (const Element& element : drawing.elements) all.push_back(element.inside);
    return all;
}
inline Box bounds(const Drawing& drawing) {
    Box box;
    for (const Element& element : drawing.elements) box = united(box, bounds(element));
    return box;
}

}  // namespace strandline
