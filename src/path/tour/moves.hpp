#pragma once
// The moves of the local search: one a file, each with three verbs. evaluate: is there a gain here (the move
// is remembered); apply: carry it out; name. Costs are looked at through Sequence::gap alone, so that another
// cost has one place to go.
#include <random>
#include <vector>

#include "path/tour/near.hpp"
#include "path/tour/sequence.hpp"

namespace strandline::tour {

/// What all moves work on.
struct Search {
    Sequence tour;
    const Candidates& candidates;
    std::mt19937_64 random;
    std::vector<Candidates::Near>
        longest;               ///< nodes of the longest links: candidates of loose nodes, which are near all
    std::vector<int> touched;  ///< nodes whose link changed: what the next look starts from
};
/// Uniform in 0 .. n-1; the bias of n / 2^32 does not matter here.
inline int below(std::mt19937_64& random, int n) {
    return static_cast<int>(((random() >> 32) * static_cast<std::uint64_t>(n)) >> 32);
}

/// How many candidates an exchange tries at each depth. Narrow repairs what a kick broke; wide is for what is
/// far from good: it costs three times as much a node and leaves half the excess.
inline constexpr int narrow[most_links] = {0, 5, 3, 1, 1, 1}, wide[most_links] = {0, 8, 5, 3, 2, 1};

/// Sequential exchange of up to `most_links` links (Lin and Kernighan, Operations Research 21, 1973;
/// depth-first without a feasibility check on the way: the ring is tested only where closing it would gain,
/// which is rare).
template <const int* breadth>
class Exchange {
  public:
    static constexpr const char* name = "exchange";
    /// Gain of the first improving exchange that begins by taking out the link of `node`; 0: none.
    double evaluate(Search& search, int node);
    void apply(Search& search) const;

  private:
    template <int k>
    double deeper(Search& search, double gain);
    /// Whether the rules are kept after it.
    bool allowed(Search& search, int k) const;
    int t_[2 * most_links] = {};
    int k_ = 0;
};
extern template class Exchange<narrow>;
extern template class Exchange<wide>;

/// A polygon is taken out and put elsewhere, at whichever vertex suits the new place.
class Reinsert {
  public:
    static constexpr const char* name = "reinsert";
    double evaluate(Search& search, int piece);
    void apply(Search& search) const;

  private:
    int t_[6] = {};
    int piece_ = 0, choice_ = 0;
};

/// A polygon stays where it is in the order and is entered at its best vertex there.
class Revertex {
  public:
    static constexpr const char* name = "revertex";
    double evaluate(const Search& search, int piece);
    void apply(Search& search) const;

  private:
    int piece_ = 0, choice_ = 0;
};
/// All vertices of runs of polygons at once: the shortest path through their vertices in the given order.
/// Returns the gain. O(sum of V_i V_(i+1)).
double choose_all_vertices(Search& search);
/// The same for one polygon and its nearest companions in the order.
double choose_vertices_around(Search& search, int piece);

/// The kick: three neighbouring short runs change places, B C D -> D C B (Martin, Otto, Felten, Complex
/// Systems 5, 1991). No sequential exchange of few links undoes it. Needs four pieces or more, the gate
/// counted.
class Bridge {
  public:
    static constexpr const char* name = "bridge";
    /// longest_run: pieces in a run at most; strewn: kicks in a hundred whose links are near each other in
    /// the plane, wherever they are in the order.
    Bridge(int longest_run, int strewn) : longest_run_(longest_run), strewn_(strewn) {}
    /// Picks a place at random; the gain, as a rule below 0.
    double evaluate(Search& search);
    void apply(Search& search) const;
    const int* nodes() const { return t_; }

  private:
    int longest_run_, strewn_;
    int t_[8] = {};
};

}  // namespace strandline::tour
