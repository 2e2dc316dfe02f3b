#include "plan/pipeline/measured.hpp"

#include <algorithm>

#include "plan/parts/parts.hpp"
#include "plan/pipeline/surroundings.hpp"

namespace strandline::pipeline {

bool MeasuredPieces::measure(Figures& figures, const std::vector<trajectory::Placed>& pieces,
                             const DriveArea& area, const Robot& robot) {
    if (area.border != area_.border || area.keep_out != area_.keep_out || robot != robot_) kept_.clear();
    area_ = area;
    robot_ = robot;
    for (auto& [key, one] : kept_) one.used = false;
    bool within = true;
    for (const trajectory::Placed& placed : pieces) {
        One& one = kept_[placed.piece.get()];
        if (!one.piece) {
            one.piece = placed.piece;
            std::vector<Sample> samples = placed.piece->samples;
            one.within = stays_within(samples, area, robot);
            samples.push_back(placed.piece->end);
            parts::measure(one.figures, samples);
        }
        one.used = true;
        within = within && one.within;
        const Figures& own = one.figures;
        figures.drawn += own.drawn;
        figures.up_driven += own.up_driven;
        figures.loops_driven += own.loops_driven;
        figures.tightest_up = std::max(figures.tightest_up, own.tightest_up);
        figures.tightest_drawn = std::max(figures.tightest_drawn, own.tightest_drawn);
        figures.time = placed.t;
    }
    std::erase_if(kept_, [](const auto& entry) { return !entry.second.used; });
    return within;
}

}  // namespace strandline::pipeline
