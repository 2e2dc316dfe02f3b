#pragma once
// Private to the room: what it costs to drive from one candidate to another, by what is finished before.
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <vector>

#include "path/order/candidates.hpp"
#include "path/order/hard.hpp"
#include "path/order/marks.hpp"

namespace strandline::order {

/// Whether the drive may go straight on from the end of one rake path to the start of the next.
bool nearly_touch(Pose from, const Stroke& drawn, Pose to, const Stroke& next, const Robot& robot,
                  const Options& options);

/// Those that are looked at, from there.
std::vector<Pose> nearest_exits(const Job& job, Point from);

/// One curve between two candidates.
struct Passage {
    double length = 0;  ///< metres, turns on the spot included
    struct Spoils {
        int group;
        double cost;  ///< metres that it is worth, once that group is drawn
    };
    std::vector<Spoils> spoils = {};
};

/// All candidates of all groups, numbered, and the passages between them. Passages are Dubins' words, the
/// longer ones too where the shorter ones spoil something; found when first asked for, and replaced by what
/// was really driven.
class Pairs {
  public:
    Pairs(const Job& job, const Choices& choices, const Robot& robot, const Options& options);

    const std::vector<Candidate>& all() const { return candidates_; }
    int group_of(int candidate) const {
        return candidates_[static_cast<std::size_t>(candidate)].going.step.element;
    }
    /// Candidates of a group: first to before end.
    std::pair<int, int> of_group(int group) const {
        return {first_[static_cast<std::size_t>(group)], first_[static_cast<std::size_t>(group) + 1]};
    }
    /// From where it is parked to a candidate that is the first; nothing is finished then.
    double from_parked(int candidate);
    /// From a candidate that is the last to the cheapest exit; all is finished then.
    double to_exit(int candidate);
    /// No passage is shorter.
    double shortest(int from, int to) { return entry(from, to).shortest; }
    /// Shortest first; none is longer than another that spoils no more.
    const std::vector<Passage>& passages(int from, int to);
    /// What was driven takes the place of what was guessed.
    void learn(int from, int to, std::vector<Passage> driven);
    bool learnt(int from, int to) { return entry(from, to).learnt; }
    /// What a metre costs, metres: within areas, or with the footprint where it must not be.
    struct Rates {
        double area = 0, hard = 0;
    };
    /// Of the group `left` there is no way round: a metre over it costs in full.
    Passage passage(double length, const Curve& curve, const Rates& rates, int left = -1) const;
    Touched touched(const Curve& curve) const { return marks_.touched(curve); }
    const Hard& hard() const { return hard_; }

  private:
    struct Entry {
        double shortest = 0;
        bool weighed = false, learnt = false;
        std::vector<Passage> passages;
    };
    Entry& entry(int from, int to);
    /// Where the number of the pair's entry is kept; -1: there is none yet.
    int& number(int from, int to);
    Entry first_look(int from, int to) const;
    /// Metres of turning on the spot, driving straight and turning again.
    double turned_straight(Pose from, Pose to) const;
    /// The way that backs up, if that is worth less metres than `below`.
    std::optional<Curve> backed_guess(Pose from, Pose to, double below) const;
    /// The cheapest of the words from pose to pose; with all that is spoilt, or none.
    double cheapest_word(Pose from, Pose to, bool all_finished) const;

    const Job& job_;
    const Robot& robot_;
    const Options& options_;
    std::vector<Candidate> candidates_;
    std::vector<int> first_;
    Hard hard_;
    Marks marks_;
    std::unordered_map<int, double> from_parked_, to_exit_;  ///< by candidate, those that were asked for
    std::deque<Entry> entries_;
    std::vector<int> table_;                          ///< numbers by pair, where that is not too many ...
    std::unordered_map<std::uint64_t, int> numbers_;  ///< ... else those that are asked for
};

}  // namespace strandline::order
