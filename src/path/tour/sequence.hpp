#pragma once
// The tour as an array of nodes, with an undo log. Places 2k and 2k+1 hold the two nodes of one piece;
// *links*, the edges that may be removed, lie between 2k+1 and 2k+2, round the ring. Only the ring matters:
// which way it is read is settled by the gate.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "path/tour/model.hpp"

namespace strandline::tour {

/// Links a sequential exchange may remove at most. Five are LKH's default; the sixth costs little here, where
/// the mate of a node is given and only one branch goes so deep.
inline constexpr int most_links = 6;

/// What a move does: the links (t0 t1), (t2 t3) ... go; t1 t2, t3 t4, ... are joined, and the last node of a
/// circle with its first. `circles`: links up to the end of each circle; a sequential exchange has one.
struct Change {
    std::span<const int> t;
    std::span<const int> circles;
};

/// A stretch of the array between two removed links.
struct Run {
    int begin, count;  ///< places, round the ring
    bool backward;     ///< how it is run after the change
    int ring;          ///< which of the rings it belongs to after the change
};

class Sequence {
  public:
    Sequence(const Model& model, const std::vector<Visit>& order);

    /// Visits read so far to see whether rules are kept: what a search with rules costs.
    mutable std::uint64_t visits_read = 0;

    const Model& model() const { return *model_; }
    int nodes() const { return static_cast<int>(tour_.size()); }
    int node_at(int place) const { return tour_[static_cast<std::size_t>(place)]; }
    int place_of(int node) const { return place_[static_cast<std::size_t>(node)]; }
    Point at(int node) const { return state(node).at; }
    int choice(int piece) const { return choice_[static_cast<std::size_t>(piece)]; }

    /// The node at the other side of the link of `node`.
    int mate(int node) const { return state(node).mate; }
    /// Straight distance; 0 from and to a loose node.
    double gap(int a, int b) const {
        if (a >= loose_from_ || b >= loose_from_) return 0;
        return distance(at(a), at(b));
    }
    /// gap(node, mate(node)), kept up to date.
    double link(int node) const { return state(node).link; }
    double length() const;
    /// A flag a node for whoever searches; false again when the search is over.
    bool marked(int node) const { return state(node).marked; }
    void mark_node(int node, bool marked) { state_[static_cast<std::size_t>(node)].marked = marked; }

    /// Whether a sequential exchange of k links leaves one ring. O(k^2), small.
    bool closes(const int* t, int k) const;
    /// The runs of a change in the order of the array, each with its ring; the number of rings. O(k log k).
    int rings(const Change& change, std::vector<Run>& runs) const;
    /// Carries out a change that leaves one ring: everything but the longest run is laid anew, O(nodes
    /// moved).
    void exchange(const Change& change);
    void choose(int piece, int choice);

    /// Log: mark() now, back(mark) later, forget() once the state is kept for good.
    std::size_t mark() const { return log_.size(); }
    void back(std::size_t mark);
    void forget();

    /// Pieces in the order of the drive.
    std::vector<Visit> order() const;
    /// O(n): whether the order as it is keeps the rules. Without gate either way of reading from the anchor
    /// will do.
    bool keeps_rules() const;

  private:
    /// All a search asks of a node, in half a cache line.
    struct State {
        Point at;
        double link = 0;
        int mate = 0;
        bool marked = false;
    };
    struct Entry {
        int begin, count;  ///< count < 0: a choice, of piece `begin`
        std::size_t saved;
        int ends;  ///< nodes whose link changed: saved behind the nodes of the run
    };
    /// Where the runs of a change begin and how their ends are joined.
    struct Joints {
        std::vector<int> begins, order, slot, joined;
    };
    const State& state(int node) const { return state_[static_cast<std::size_t>(node)]; }
    void find_joints(const Change& change) const;
    Run run_between(int r, int k, bool backward) const;
    /// Runs as they follow each other from the first, into runs_; fewer than all when there is another ring.
    int follow(int k) const;
    std::vector<Visit> read(int from, int step) const;
    void measure(int node);
    void lay(int begin, const int* nodes, int count);
    int wrapped(int place) const { return place >= nodes() ? place - nodes() : place; }

    const Model* model_;
    int loose_from_;
    int anchor_ = 0;  ///< without gate: the piece that comes first
    std::vector<int> tour_, place_, choice_;
    std::vector<State> state_;
    std::vector<Entry> log_;
    std::vector<int> saved_, laid_;
    mutable Joints joints_;
    mutable std::vector<Run> runs_;
};

}  // namespace strandline::tour
