#pragma once
// Collects broken laws: what is wrong at neighbouring samples is one fault, at its worst place.
#include <array>
#include <vector>

#include "result/check/check.hpp"

namespace strandline::check {

class Faults {
  public:
    /// `excess`: how bad it is, in any unit as long as it is the same for the law.
    void add(double excess, Fault fault) {
        Run& run = runs_[static_cast<std::size_t>(fault.law)];
        const bool same = run.fault >= 0 && fault.sample >= 0 &&
                          fault.sample - run.last_sample <= neighbours &&
                          faults_[static_cast<std::size_t>(run.fault)].element == fault.element;
        if (!same) {
            run = {static_cast<int>(faults_.size()), fault.sample, excess};
            faults_.push_back(std::move(fault));
            return;
        }
        run.last_sample = fault.sample;
        if (excess <= run.worst) return;
        run.worst = excess;
        faults_[static_cast<std::size_t>(run.fault)] = std::move(fault);
    }
    std::vector<Fault> take() { return std::move(faults_); }

  private:
    /// Samples: bad ones that near are one run; a law that is judged on intervals may skip one.
    static constexpr int neighbours = 3;
    static constexpr std::size_t laws = static_cast<std::size_t>(Law::step) + 1;
    struct Run {
        int fault = -1, last_sample = -1;
        double worst = 0;
    };
    std::array<Run, laws> runs_;
    std::vector<Fault> faults_;
};

/// The element that is drawn from this sample to the next, -1: none.
inline int element_of(const Plan& plan, const Sample& sample) {
    const bool known = sample.stroke >= 0 && sample.stroke < static_cast<int>(plan.strokes.size());
    return known ? plan.strokes[static_cast<std::size_t>(sample.stroke)].element : -1;
}

/// Laws of the machine: what each sample says and how one follows from the other. Fills Report::time,
/// up_driven, max_*_up.
void check_motion(const Plan& plan, Faults& faults, Report& report);
/// Laws of the drawing: lines and fill strokes are where they should be, each once. Fills Report::drawn,
/// worst_offset.
void check_drawn(const Plan& plan, const Options& options, Faults& faults, Report& report);
/// Fills Report::over_finished.
void measure_finished(const Plan& plan, Report& report);

}  // namespace strandline::check
