#include "result/fidelity/fidelity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "result/fidelity/lines.hpp"

namespace strandline::fidelity {
namespace {

using surface::Surface;

/// Metres round the canvas that are still laid: farther out the drive is broken, and the raster would only
/// grow.
constexpr double outside_canvas = 10;

const Region* region_of(const Element& element) {
    const auto* held = std::get_if<RegionElement>(&element.what);
    return held == nullptr || held->region.outer.size() < 3 ? nullptr : &held->region;
}

/// A band of `width` along a closed or open chain.
void mark_band(Surface& sand, const Polyline& line, bool closed, double width, unsigned bits) {
    const std::size_t count = line.size(), pieces = closed ? count : count - 1;
    Point last_left{}, last_right{};
    for (std::size_t k = 0; k < pieces; ++k) {
        const Point a = line[k], b = line[(k + 1) % count];
        const Point side = width / 2 * left_normal(normalized(b - a));
        if (k > 0) sand.mark(swept_bar(last_left, last_right, a + side, a - side).outline(), bits);
        sand.mark(swept_bar(a + side, a - side, b + side, b - side).outline(), bits);
        last_left = b + side;
        last_right = b - side;
    }
}

void mark_wanted(Surface& sand, const Drawing& drawing, const Robot& robot, double tolerance, Box within) {
    for (const Element& element : drawing.elements) {
        if (const Region* region = region_of(element)) {
            sand.mark(runs_in(sand, *region, within), surface::wanted_fill);
            mark_band(sand, region->outer, true, robot.rake_width(), surface::border);
            for (const Polygon& hole : region->holes)
                mark_band(sand, hole, true, robot.rake_width(), surface::border);
        } else if (const auto* line = std::get_if<LineElement>(&element.what)) {
            const Polyline chords = flattened(line->path, tolerance);
            if (chords.size() > 1)
                mark_band(sand, chords, line->path.closed, groove_width(robot, line->pins),
                          surface::wanted_line);
        }
    }
}

/// Runs of cells of each flaw while cells come by row.
class Flaws {
  public:
    void add(Flaw flaw, int i, int j) {
        std::vector<RowRun>& runs = runs_[static_cast<std::size_t>(flaw)];
        if (!runs.empty() && runs.back().row == j && runs.back().end == i)
            ++runs.back().end;
        else
            runs.push_back({j, i, i + 1});
    }
    /// Patches that hold at least `least` metres each way.
    std::vector<Place> places(const Grid& grid, double least) const {
        std::vector<Place> list;
        for (std::size_t k = 0; k < runs_.size(); ++k)
            for (const Patch& patch : patches(grid, runs_[k]))
                if (patch.width >= least && patch.height >= least)
                    list.push_back({static_cast<Flaw>(k), patch.at, patch.area});
        std::ranges::stable_sort(list, std::greater{}, &Place::area);
        return list;
    }
    double area(Flaw flaw, double cell) const {
        double cells = 0;
        for (const RowRun& run : runs_[static_cast<std::size_t>(flaw)]) cells += run.end - run.first;
        return cells * cell * cell;
    }

  private:
    std::array<std::vector<RowRun>, 5> runs_;
};

void count(const Surface& sand, double least, Report& report) {
    std::size_t area = 0, raked_area = 0, spilt = 0, both = 0, either = 0, over = 0, lacking = 0;
    Flaws flaws;
    sand.visit_cells([&](int i, int j, const surface::Tile& tile, std::size_t place) {
        const unsigned bits = tile.bits[place];
        if (bits == 0) return;
        const bool in_fill = (bits & surface::wanted_fill) != 0, is_raked = (bits & surface::raked) != 0;
        const bool wanted = (bits & (surface::wanted_fill | surface::wanted_line)) != 0;
        area += in_fill;
        raked_area += in_fill && is_raked;
        const bool spill = is_raked && !wanted && (bits & surface::filled) != 0;
        spilt += spill;
        both += wanted && is_raked;
        either += wanted || is_raked;
        if ((bits & surface::border) != 0) {
            over += spill;
            lacking += in_fill && !is_raked;
        }
        const bool is_rolled = (bits & surface::rolled) != 0;
        if (wanted && !is_raked) flaws.add(Flaw::missing, i, j);
        if (!wanted && is_raked) flaws.add(Flaw::stray, i, j);
        if (!wanted && !is_raked && is_rolled) flaws.add(Flaw::track, i, j);
        if (wanted && is_raked && is_rolled)
            flaws.add(in_fill ? Flaw::track_on_fill : Flaw::track_on_line, i, j);
    });
    const double cell = sand.cell_size(), square = cell * cell;
    const auto share = [](std::size_t part, std::size_t whole) {
        return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
    };
    report.fill_area = static_cast<double>(area) * square;
    report.fill_union = area == 0 ? 1 : share(raked_area, area + spilt);
    report.coverage = area == 0 ? 1 : share(raked_area, area);
    report.spill = share(spilt, area);
    report.intersection_over_union = either == 0 ? 1 : share(both, either);
    if (report.fill_perimeter > 0) {
        constexpr double centimetres = 100;
        report.border_over = centimetres * static_cast<double>(over) * square / report.fill_perimeter;
        report.border_missing = centimetres * static_cast<double>(lacking) * square / report.fill_perimeter;
    }
    report.missing = flaws.area(Flaw::missing, cell);
    report.stray = flaws.area(Flaw::stray, cell);
    report.track = flaws.area(Flaw::track, cell);
    report.track_on_line = flaws.area(Flaw::track_on_line, cell);
    report.track_on_fill = flaws.area(Flaw::track_on_fill, cell);
    report.places = flaws.places(sand, least);
}

}  // namespace

const char* name_of(Flaw flaw) {
    switch (flaw) {
        case Flaw::missing:
            return "missing";
        case Flaw::stray:
            return "stray groove";
        case Flaw::track:
            return "track";
        case Flaw::track_on_line:
            return "track on a line";
        case Flaw::track_on_fill:
            return "track on an area";
    }
    return "";
}

std::vector<int> elements_of(const std::vector<Sample>& samples, const std::vector<Stroke>& strokes) {
    std::vector<int> elements;
    elements.reserve(samples.size());
    for (const Sample& sample : samples) {
        const bool known = sample.stroke >= 0 && sample.stroke < static_cast<int>(strokes.size());
        elements.push_back(known ? strokes[static_cast<std::size_t>(sample.stroke)].element : -1);
    }
    return elements;
}
surface::Drive drive_of(const Plan& plan) {
    return {plan.robot, plan.samples, elements_of(plan.samples, plan.strokes)};
}

Judged judged(const Drawing& drawing, const surface::Drive& drive, const Options& options,
              const Progress& progress) {
    surface::Options laying;
    laying.cell = options.cell > 0 ? options.cell : surface::cell_for(drive.robot);
    laying.within = grown({{0, 0}, {drawing.canvas.width, drawing.canvas.height}}, outside_canvas);
    for (const Element& element : drawing.elements) laying.fills.push_back(is_region(element));
    Judged result{{}, surface::laid(drive, laying, progress)};
    mark_wanted(result.sand, drawing, drive.robot, laying.cell / 4, laying.within);
    Report& report = result.report;
    report.cell = laying.cell;
    for (const Element& element : drawing.elements)
        if (region_of(element) != nullptr) report.fill_perimeter += length(element);
    count(result.sand, drive.robot.pin_pitch, report);
    measure_lines(drawing, drive, result.sand, report);
    return result;
}

}  // namespace strandline::fidelity
