#pragma once
// The tour as an array of nodes, with an undo log. Places 2k and 2k+1 hold the two nodes of one piece;
// *links*, the edges that may be removed, lie between 2k+1 and 2k+2, round the ring. Only the ring matters:
// which way it is read is settled by the gate.
#include <vector>

#include "path/tour/model.hpp"

namespace strandline::tour {

/// Links a move may remove at most: sequential exchanges go to 5 (LKH's default; FINDINGS of this project:
/// enough).
inline constexpr int most_links = 5;

class Sequence {
  public:
    Sequence(const Model& model, const std::vector<Visit>& order);

    /// Visits read so far to see whether rules are kept: what a search with rules costs.
    mutable std::uint64_t visits_read = 0;

    const Model& model() const { return *model_; }
    int nodes() const { return static_cast<int>(tour_.size()); }
    int node_at(int place) const { return tour_[static_cast<std::size_t>(place)]; }
    int place_of(int node) const { return place_[static_cast<std::size_t>(node)]; }
    Point at(int node) const { return at_[static_cast<std::size_t>(node)]; }
    int choice(int piece) const { return choice_[static_cast<std::size_t>(piece)]; }

    /// The node at the other side of the link of `node`.
    int mate(int node) const {
        const int place = place_of(node), last = nodes() - 1;
        if (place & 1) return node_at(place == last ? 0 : place + 1);
        return node_at(place == 0 ? last : place - 1);
    }
    /// Straight distance; 0 from and to a loose node.
    double gap(int a, int b) const {
        if (a >= loose_from_ || b >= loose_from_) return 0;
        return distance(at(a), at(b));
    }
    /// gap(node, mate(node)), kept up to date.
    double link(int node) const { return link_[static_cast<std::size_t>(node)]; }
    double length() const;

    /// Whether taking out the links (t0 t1), (t2 t3) ... and joining t1 t2, t3 t4, ... t(2k-1) t0 leaves one
    /// ring. O(k^2), small.
    bool closes(const int* t, int k) const;
    /// Does that: everything but the longest run is laid anew, O(nodes moved). circle < k: the first `circle`
    /// links are joined among themselves in this manner, and so are the others (a double bridge is 2 + 2).
    void exchange(const int* t, int k, int circle = most_links);
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
    struct Entry {
        int begin, count;  ///< count < 0: a choice, of piece `begin`
        std::size_t saved;
        int ends;  ///< nodes whose link changed: saved behind the nodes of the run
    };
    struct Run {
        int begin, count;  ///< places, round the ring
        bool backward;
    };
    /// Runs in their new order, from the run that begins after the first link; the number of runs met before
    /// the ring closes.
    int new_order(const int* t, int k, int circle, Run* runs) const;
    std::vector<Visit> read(int from, int step) const;
    void measure(int node) { link_[static_cast<std::size_t>(node)] = gap(node, mate(node)); }
    int wrapped(int place) const { return place >= nodes() ? place - nodes() : place; }

    const Model* model_;
    int loose_from_;
    int anchor_ = 0;  ///< without gate: the piece that comes first
    std::vector<int> tour_, place_, choice_;
    std::vector<Point> at_;
    std::vector<double> link_;
    std::vector<Entry> log_;
    std::vector<int> saved_, laid_;
};

}  // namespace strandline::tour
