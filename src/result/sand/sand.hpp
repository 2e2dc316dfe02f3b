#pragma once
// What a plan leaves in the sand: every pin's groove laid in time order on a raster; coverage, spill and
// finished ground driven over. Cells' times are metres driven by P. What lies more than 5 m outside
// field_of(plan), or jumps by more than 1 m, is not laid.
#include <vector>

#include "machine/ground/ground.hpp"
#include "plan/model/model.hpp"

namespace strandline::sand {

struct Options {
    double cell = 0.02;     ///< metres
    double pass_gap = 0.5;  ///< metres driven after which raking a cell again counts as a second pass
    double settled = 0.7;   ///< metres driven after which raked ground counts as finished for wheels
};
/// A region's account, by the cells whose centres it holds. A cell raked n times counts n - 1 times as
/// overdraw.
struct Account {
    int element = -1;
    double area = 0, covered = 0, overdraw = 0;  ///< m^2
};
/// Ground that was finished and is driven over later: a region's raked cells under wheels, rake up or in
/// another element's stroke, each cell once a pass; drawn lines crossed by P rake up (apart from crossings
/// within 5 cm of either end of that move, of P or of the rake: leaving a line's own end is no crossing).
/// Events less than pass_gap apart are one.
struct Blemish {
    Point at;           ///< where it begins
    double area = 0;    ///< m^2 of raked cells under wheels (fill regions) ...
    int crossings = 0;  ///< ... or lines crossed
    int element = -1;   ///< whose ground
    double t = 0;       ///< s, when
};
/// Sand of a region that no pin raked, in one piece that is at least a pin wide both along x and along y.
struct Bare {
    Point at;  ///< the middle of its longest row of cells
    double area = 0;
    int element = -1;
};
struct Sand {
    Ground ground;
    std::vector<Account> regions;
    std::vector<Bare> bare;  ///< largest first
    double spill = 0;        ///< m^2 raked outside every region by strokes of no line
    double driven = 0;       ///< m of P's path
    std::vector<Blemish> blemishes;
};
/// Lays the plan. A plan's numbers must be finite. O(driven length x width / cell^2 + area of regions /
/// cell^2).
Sand simulate(const Plan& plan, const Options& options = {}, const Progress& progress = {});

}  // namespace strandline::sand
