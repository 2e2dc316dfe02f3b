#pragma once
// Who is near whom: a kd-tree over points that belong to owners, and from it each node's candidate list.
#include <vector>

#include "math/geometry/geometry.hpp"
#include "path/tour/model.hpp"

namespace strandline::tour {

/// Balanced kd-tree (Bentley, Communications of the ACM 18, 1975); points can be taken out. A grid was not
/// used: drawings have points in heaps, where its cells overflow.
class Tree {
  public:
    struct Entry {
        Point at;
        int owner;
    };
    explicit Tree(std::vector<Entry> entries);
    /// Index of the nearest entry still in, -1 when none is left. Ties: the lower index of the tree. O(log n)
    /// on average.
    int nearest(Point p) const;
    const Entry& entry(int index) const { return entries_[static_cast<std::size_t>(index)]; }
    int size() const { return static_cast<int>(entries_.size()); }
    void remove(int index);
    /// The nearest `count` owners other than `self`, with squared distance, nearest first. `found` is added
    /// to: of two distances to one owner the smaller stays.
    struct Found {
        double squared;
        int owner;
    };
    void nearest_owners(Point p, int self, int count, std::vector<Found>& found) const;

  private:
    struct Cell {
        Box box;
        int begin, end, left, right, parent, alive;
    };
    int build(int begin, int end, int parent);
    std::vector<Entry> entries_;
    std::vector<bool> out_;
    std::vector<int> leaf_of_;
    std::vector<Cell> cells_;
};

/// Candidate lists: for each node the nodes worth being joined to, nearest first. Loose gate nodes are
/// candidates of every node.
struct Candidates {
    struct Near {
        int node;
        bool exact;  ///< neither of the two is a polygon: gap is the distance
        double gap;  ///< a polygon is measured at its best vertex, so this may be less than the distance now
    };
    std::vector<Near> all;
    std::vector<int> first;  ///< by node; one past the end too
};
/// `count` owners a node. O(n log n) time; O(n count) memory.
Candidates find_candidates(const Model& model, int count);

/// Greedy edges (Bentley, ORSA Journal on Computing 4, 1992): the shortest candidates that can stand
/// together, then, round by round, the shortest links between ends of the rows so far. For problems without
/// rules; begins at the start. Polygons count as near as their nearest vertices, each stands at its first.
/// O(n log n).
std::vector<Visit> greedy_order(const Model& model, const Candidates& near);

}  // namespace strandline::tour
