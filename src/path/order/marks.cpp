#include "path/order/marks.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::order {
namespace {

/// Crossings nearer than this to a curve's ends are no blemish.
constexpr double own_end = 0.05;
/// Chords stand this far off their line at most, in least radii.
constexpr double chord_error = 0.01;
/// Sides of cells in least radii; larger where there would be too many.
constexpr double square = 0.5, area_cell = 0.2;
constexpr double most_cells = 250'000;
/// A curve is gone along by chords that turn by no more than this (radians), and no longer than a cell of
/// areas.
constexpr double chord_turn = 0.15;
/// Metres of a chord, where there is no grid.
constexpr double longest_chord = 0.25;

Raster cells_over(Box box, double cell) {
    box = grown(box, cell);
    const double least = std::sqrt(box.width() * box.height() / most_cells);
    return raster_over(box, std::max(cell, least));
}

}  // namespace

Marks::Cells Marks::gathered(std::size_t cells, const std::vector<std::pair<std::size_t, int>>& entries) {
    Cells result;
    result.first.assign(cells + 1, 0);
    for (const auto& [cell, item] : entries) ++result.first[cell + 1];
    for (std::size_t k = 0; k < cells; ++k) result.first[k + 1] += result.first[k];
    result.items.resize(entries.size());
    std::vector<int> next = result.first;
    for (const auto& [cell, item] : entries) result.items[static_cast<std::size_t>(next[cell]++)] = item;
    return result;
}

Marks::Marks(const Job& job, const Avoid& avoid, const Robot& robot)
    : hard_(static_cast<int>(job.groups.size())) {
    const double side = std::min({robot.front, robot.back, robot.half_width});
    Regions hard = job.keep_out;
    if (job.field) {
        const Box box = bounds(*job.field);
        inside_ = grown(box, -side);
        const Regions whole{{{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, {}}};
        hard = united(hard.empty() ? hard : intersected(hard, whole), subtracted(whole, {*job.field}));
    }
    if (avoid.on) take_lines(job, robot.min_radius);
    take_areas(job, avoid, hard.empty() || side <= 0 ? hard : inset(hard, -side));
}

void Marks::take_lines(const Job& job, double radius) {
    Box box;
    for (std::size_t g = 0; g < job.groups.size(); ++g) {
        if (!job.groups[g].area.empty()) continue;
        for (const Stroke& stroke : job.groups[g].work.strokes)
            for (const Curve& curve : stroke.rake_path) {
                const double bend = std::max(max_curvature(curve), 0.01 / radius);
                const double step = std::min(radius, std::sqrt(8 * chord_error * radius / bend));
                const std::vector<CurvePoint> points = sampled(curve, step);
                for (std::size_t i = 1; i < points.size(); ++i) {
                    chords_.push_back({points[i - 1].pose.at, points[i].pose.at, static_cast<int>(g)});
                    box = including(including(box, chords_.back().a), chords_.back().b);
                }
            }
    }
    if (chords_.empty()) return;
    squares_ = cells_over(box, square * radius);
    std::vector<std::pair<std::size_t, int>> entries;
    for (std::size_t k = 0; k < chords_.size(); ++k)
        for_squares(chords_[k].a, chords_[k].b,
                    [&](std::size_t cell) { entries.emplace_back(cell, static_cast<int>(k)); });
    by_square_ = gathered(squares_.size(), entries);
    asked_.assign(chords_.size(), 0);
}

void Marks::take_areas(const Job& job, const Avoid& avoid, const Regions& hard) {
    Box box = bounds(hard);
    for (const Group& group : job.groups)
        if (avoid.on && !group.area.empty()) box = united(box, bounds(group.area));
    if (box.empty()) return;
    const double cell = area_cell * avoid.radius;
    areas_ = cells_over(grown(box, avoid.clearance), cell);
    std::vector<std::pair<std::size_t, int>> entries;
    const auto take = [&](const Regions& area, int number) {
        for (const Run& run : runs_inside(areas_, area))
            for (int column = run.first; column < run.end; ++column)
                entries.emplace_back(areas_.index(column, run.row), number);
    };
    for (std::size_t g = 0; avoid.on && g < job.groups.size(); ++g) {
        if (job.groups[g].area.empty()) continue;
        const double grow = std::max(0.0, avoid.clearance - areas_.cell);
        take(inset(job.groups[g].area, -grow), static_cast<int>(g));
    }
    if (!hard.empty()) take(hard, hard_);
    by_cell_ = gathered(areas_.size(), entries);
}

template <class What>
void Marks::for_squares(Point a, Point b, What&& what) const {
    const Point p = squares_.in_cells(a), q = squares_.in_cells(b);
    const auto column = [&](double x) {
        return std::clamp(static_cast<int>(std::lround(x)), 0, squares_.columns - 1);
    };
    const auto row = [&](double y) {
        return std::clamp(static_cast<int>(std::lround(y)), 0, squares_.rows - 1);
    };
    for (int j = row(std::min(p.y, q.y)); j <= row(std::max(p.y, q.y)); ++j)
        for (int i = column(std::min(p.x, q.x)); i <= column(std::max(p.x, q.x)); ++i)
            what(squares_.index(i, j));
}

void Marks::cross(Point a, Point b, Point begin, Point end, double travelled,
                  std::vector<Touch>& found) const {
    ++question_;
    for_squares(a, b, [&](std::size_t cell) {
        for (const int k : by_square_.of(cell)) {
            int& asked = asked_[static_cast<std::size_t>(k)];
            if (asked == question_) continue;
            asked = question_;
            const Chord& chord = chords_[static_cast<std::size_t>(k)];
            const Point along = b - a;
            const double left = strandline::cross(along, chord.a - a),
                         right = strandline::cross(along, chord.b - a);
            if ((left > 0) == (right > 0)) continue;
            const auto hit = crossing(a, b, chord.a, chord.b);
            if (!hit || hit->s >= 1 || hit->t >= 1) continue;
            if (distance(hit->at, begin) <= own_end || distance(hit->at, end) <= own_end) continue;
            found.push_back({chord.group, 1, 0, travelled});
        }
    });
}

Touched Marks::touched(const Curve& curve) const {
    Touched touched;
    std::vector<Touch> found;
    if (chords_.empty() && by_cell_.first.empty() && !inside_) return touched;
    const Point begin = curve.start.at, end = end_pose(curve).at;
    Pose at = curve.start;
    double travelled = 0;
    for (const Clothoid& piece : curve.pieces) {
        const double far = std::abs(piece.length);
        const double bend = std::max(std::abs(piece.curvature), std::abs(piece.end_curvature()));
        const double longest = !by_cell_.first.empty() ? areas_.cell
                               : !chords_.empty()      ? squares_.cell
                                                       : longest_chord;
        const int parts =
            std::max(1, static_cast<int>(std::ceil(std::max(far / longest, far * bend / chord_turn))));
        // Arcs have equal chords, each turned against the one before by the same angle.
        const bool arc = piece.sharpness == 0;
        const double step = piece.length / parts, metres = far / parts;
        const Point turn = unit(piece.curvature * step);
        Point from = at.at, chord = arc ? advanced(at, piece, step).at - at.at : Point{};
        for (int i = 1; i <= parts; ++i) {
            const Point to = arc ? from + chord : advanced(at, piece, step * i).at;
            chord = {chord.x * turn.x - chord.y * turn.y, chord.x * turn.y + chord.y * turn.x};
            if (!chords_.empty()) cross(from, to, begin, end, travelled, found);
            travelled += metres;
            if (inside_ && !contains(*inside_, between(from, to, 0.5))) {
                touched.hard += metres;
            } else if (!by_cell_.first.empty()) {
                const Point middle = areas_.in_cells(between(from, to, 0.5));
                const long column = std::lround(middle.x), row = std::lround(middle.y);
                if (column >= 0 && column < areas_.columns && row >= 0 && row < areas_.rows)
                    for (const int g :
                         by_cell_.of(areas_.index(static_cast<int>(column), static_cast<int>(row)))) {
                        if (g == hard_)
                            touched.hard += metres;
                        else
                            found.push_back({g, 0, metres});
                    }
            }
            from = to;
        }
        at = advanced(at, piece, piece.length);
    }
    std::ranges::stable_sort(found, {}, &Touch::group);
    std::vector<Touch>& merged = touched.groups;
    for (const Touch& touch : found) {
        if (merged.empty() || merged.back().group != touch.group) merged.push_back({touch.group});
        merged.back().crossings += touch.crossings;
        merged.back().metres += touch.metres;
        merged.back().first_crossing = std::min(merged.back().first_crossing, touch.first_crossing);
    }
    return touched;
}

}  // namespace strandline::order
