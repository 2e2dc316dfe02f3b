#pragma once
// What a plan leaves in the sand: every pin's groove laid in time order on a raster; coverage, spill and finished ground driven over.
#include <vector>

#include "machine/ground/ground.hpp"
#include "plan/model/model.hpp"

namespace strandline::sand {

struct Options {
    double cell = 0.02;              ///< metres
    double pass_gap = 0.5;           ///< metres driven after which raking a cell again counts as a second pass
    double settled = 0.7;            ///< metres driven after which raked ground counts as finished for wheels and rake
};
/// One element's account, of a region's area (cells).
struct Account {
    int element = -1;
    double area = 0, covered = 0, overdraw = 0;   ///< m^2
};
/// Ground that was finished and is driven over later, rake up or by another element's stroke.
struct Blemish {
    Point at;                        ///< where it begins
    double area = 0;                 ///< m^2 of raked cells under wheels (fill regions) ...
    int crossings = 0;               ///< ... or lines crossed
    int element = -1;                ///< whose ground
    double t = 0;                    ///< s, when
};
struct Sand {
    Ground ground;
    std::vector<Account> regions;
    double spill = 0;                ///< m^2 raked outside every region and line
    std::vector<Blemish> blemishes;
};
/// Lays the plan. O(driven length x width / cell^2).
Sand simulate(const Plan& plan, const Options& options = {}, const Progress& progress = {});

}  // namespace strandline::sand
