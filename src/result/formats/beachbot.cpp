// The robot text of 2014: two files of lines "x y rake". The rake column is a mask of seven pins, 128 for a
// turn on the spot, 129 for the end.
#include <algorithm>
#include <cmath>

#include "base/text/text.hpp"
#include "machine/pins/pins.hpp"
#include "result/formats/formats.hpp"
#include "result/formats/instants.hpp"

namespace strandline::formats {
namespace {

constexpr int text_pins = 7;  // the column's bits 6 (leftmost) to 0
constexpr unsigned turn_here = 128, end_here = 129;
constexpr double widest_step = 0.05;  // m: the robot's controller expects points at most this far apart
constexpr double longest_move =
    1e4;  // m between two samples: a jump, which `check` names; not to be filled in
constexpr int decimals = 6;

/// A mask of the robot's own pins as one of seven: fewer pins sit in the middle (one pin: bit 3), of more
/// pins the seven are down where the nearest of the robot's is.
unsigned as_seven(unsigned mask, int pins) {
    if (pins <= text_pins) return (mask << (text_pins - pins) / 2) & 127U;
    unsigned seven = 0;
    for (int bit = 0; bit < text_pins; ++bit) {
        const int nearest = std::min(31, static_cast<int>((bit + 0.5) * pins / text_pins));
        seven |= ((mask >> nearest) & 1U) << bit;
    }
    return seven;
}

class PairWriter {
  public:
    /// A robot that stands and waits is one line: a segment has a length, and this text has no time.
    void line(Point robot, Point rake, unsigned column) {
        if (robot == last_robot_ && rake == last_rake_ && column == last_column_) return;
        last_robot_ = robot;
        last_rake_ = rake;
        last_column_ = column;
        line(robot_, robot, column);
        line(rake_, rake, column);
    }
    BeachbotPair done() { return {std::move(robot_), std::move(rake_)}; }

  private:
    static void line(Text& text, Point at, unsigned column) {
        add_fixed(text, at.x, decimals);
        add(text, " ");
        add_fixed(text, at.y, decimals);
        add(text, " ");
        add_number(text, static_cast<long long>(column));
        add(text, "\n");
    }
    Text robot_, rake_;
    Point last_robot_, last_rake_;
    unsigned last_column_ = 999;  // no line yet
};

/// Lines between two samples, so that neither the robot nor the rake goes further than `widest_step` in a
/// line.
void lines_between(PairWriter& out, const Robot& robot, const Sample& a, const Sample& b, unsigned column) {
    const double farthest = farthest_move(a, b);
    if (!(farthest > widest_step) || !(farthest < longest_move)) return;
    // A tenth closer than the limit: the rake does not move evenly while the robot does.
    for (const Instant& at : instants_between(robot, a, b, std::ceil(farthest / (0.9 * widest_step))))
        out.line(at.pose.at, at.rake, column);
}

}  // namespace

BeachbotPair write_beachbot(const Plan& plan) {
    const auto samples = pins::told(plan.robot, plan.samples);
    PairWriter out;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& sample = samples[i];
        const bool last = i + 1 == samples.size();
        const bool turns = !last && sample.motion == Motion::pivot;
        const unsigned column = last ? end_here : turns ? turn_here : as_seven(sample.mask, plan.robot.pins);
        out.line(sample.pose.at, sample.rake, column);
        if (turns) {  // one line, however long the turn: it ends where the next line is
            while (i + 2 < samples.size() && samples[i + 1].motion == Motion::pivot &&
                   samples[i + 1].pose.at == sample.pose.at)
                ++i;
        } else if (!last) {
            lines_between(out, plan.robot, sample, samples[i + 1], column);
        }
    }
    return out.done();
}

}  // namespace strandline::formats
