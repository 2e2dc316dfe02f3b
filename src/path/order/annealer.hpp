#pragma once
// Private to the room: the row while it is annealed. What it costs is in sequence.cpp, its moves in
// moves.cpp.
#include "path/order/sequence.hpp"

namespace strandline::order {

class Annealer {
  public:
    Annealer(Row row, const Job& job, Pairs& pairs, std::uint64_t seed);
    Annealed run(const Annealing& options, const Progress& progress);

  private:
    double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
    int group_at(int k) const { return pairs_.group_of(row_[static_cast<std::size_t>(k)]); }
    int& place_at(int k) { return place_[static_cast<std::size_t>(group_at(k))]; }
    const Candidate& candidate_at(int k) const {
        return pairs_.all()[static_cast<std::size_t>(row_[static_cast<std::size_t>(k)])];
    }

    /// From where the drive is to begin, and to where it is to end.
    double to_ends(int k);
    /// What it costs to come to place k and to be there.
    double leg(int k);
    /// No more than that.
    double least_leg(int k);
    void find_neighbours();
    /// `part_` in place of what is at `from` and after; taken where it costs no more than allowed.
    void offer(int from, double allowed);

    /// A move at random; taken where it costs no more than allowed.
    void step(double allowed);
    /// Another way through one group.
    void go_otherwise(int k, double allowed);
    /// From k to the place of a neighbour (either before or after it) the other way round.
    void turn_about(int k, double allowed);
    /// A part that begins at k goes beside a neighbour, as it is or turned about.
    void move(int k, double allowed);
    /// The same way through its group, the other way round.
    int mate(int candidate) const;
    int area_at(int k) const { return area_[static_cast<std::size_t>(group_at(k))]; }
    /// Appends what is at `first` to before `end` to `part_`.
    void take(int first, int end);
    /// The other way round; strokes of one area that follow one another stay as they are.
    void take_turned(int first, int end);
    /// Whether what must come before still does, with `part_` at `from`.
    bool keeps_order(int from);
    bool glued_after(int k) const {
        return k >= 0 && k < size_ && glued_[static_cast<std::size_t>(group_at(k))] != 0;
    }
    bool one_batch(int from, int to) const {
        return batch_[static_cast<std::size_t>(group_at(from))] ==
               batch_[static_cast<std::size_t>(group_at(to))];
    }

    const Job& job_;
    Pairs& pairs_;
    Row row_;
    int size_;
    std::vector<int> place_;  ///< by group
    std::vector<std::vector<int>> after_, near_;
    std::vector<int> batch_;
    std::vector<char> glued_;
    std::vector<int> area_;   ///< by group: the element whose fill it is a stroke of; -1: none
    std::vector<int> tried_;  ///< by group: its place in what is tried
    std::mt19937_64 random_;
    std::vector<double> costs_, next_;
    Row part_;
    double sum_ = 0;
    std::uint64_t work_ = 0;
};

}  // namespace strandline::order
