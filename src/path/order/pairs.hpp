#pragma once
// Private to the room: what it costs to drive from one candidate to another, by what is finished before.
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "path/order/candidates.hpp"
#include "path/order/marks.hpp"

namespace strandline::order {

/// Whether the drive may go straight on from the end of one rake path to the start of the next.
bool nearly_touch(Pose from, Pose to, const Robot& robot, const Options& options);

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
    /// No passage is shorter.
    double shortest(int from, int to) { return entry(from, to).shortest; }
    /// Shortest first; none is longer than another that spoils no more.
    const std::vector<Passage>& passages(int from, int to);
    /// What was driven takes the place of what was guessed.
    void learn(int from, int to, std::vector<Passage> driven);
    bool learnt(int from, int to) { return entry(from, to).learnt; }
    /// `area_cost`: of a metre within areas, metres; of the group `left`, there is no way round: in full.
    Passage passage(double length, const Curve& curve, double area_cost, int left = -1) const;
    std::vector<Touch> touched(const Curve& curve) const { return marks_.touched(curve); }

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

    const Job& job_;
    const Robot& robot_;
    const Options& options_;
    std::vector<Candidate> candidates_;
    std::vector<int> first_;
    Marks marks_;
    std::deque<Entry> entries_;
    std::vector<int> table_;                          ///< numbers by pair, where that is not too many ...
    std::unordered_map<std::uint64_t, int> numbers_;  ///< ... else those that are asked for
};

}  // namespace strandline::order
