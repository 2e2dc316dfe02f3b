#pragma once
// A lower bound on what is left to drive: spanning trees with prices (Held and Karp, Operations Research 18,
// 1970, and Mathematical Programming 1, 1971), over the pieces and one more for the end.
//
// key: stop      something that must be passed once: a piece; the last stop is the end of the drive
//      option    a way to pass a stop: a line from either end, a polygon at one of its vertices
//      terminal  where a leg can touch a stop: 2s and 2s + 1, the ends of line s, one leg each; 2s alone for
//      a polygon (two legs, at
//                any of its vertices) and for the end (one leg)
//      price     added to every leg that touches a terminal; the bound takes it back as often as a tour
//      touches it
#include <cstdint>
#include <vector>

#include "math/geometry/geometry.hpp"

namespace strandline::tour {

struct Option {
    int stop;
    bool backward;  ///< of a line
    int choice;     ///< of a polygon
    Point in, out;
};
/// A path from `from` (or anywhere) through the stops in `all` to `to` (or anywhere).
struct Route {
    std::vector<Option> options;  ///< by stop, ascending
    std::vector<int> first;       ///< by stop: its first option; one past the end too
    std::vector<bool> polygon;    ///< by stop
    std::uint64_t all = 0;
    const Point* from = nullptr;
    const Point* to = nullptr;

    int stops() const { return static_cast<int>(polygon.size()); }
};

class Bound {
  public:
    /// Prices by subgradient ascent towards `upper`; options of polygons that no path up to `upper` +
    /// tolerance can use are dropped from `route`. O(rounds stops^2 + vertices^2).
    Bound(Route& route, double upper, double tolerance);
    /// No path is shorter than this.
    double root() const { return root_; }
    /// Least cost through every stop in the mask (not empty) to the end, without the first leg. O(stops^2).
    double tree(std::uint64_t mask) const;
    /// Least first legs, with prices, from the exits of the options [first, last) to each terminal.
    std::vector<double> reach(int first, int last) const;
    /// Least of them that leads into the mask. O(stops).
    double first_leg(const std::vector<double>& reach, std::uint64_t mask) const;

  private:
    double spanned(std::uint64_t mask, std::vector<int>* degrees) const;
    double first_leg(int* terminal) const;
    double back(std::uint64_t mask) const;
    void measure();
    void merge();
    void ascend(double upper);
    bool drop(double limit);

    Route* route_;
    int stops_, width_;           ///< stops with the end; terminals, two a stop
    std::vector<double> gap_;     ///< terminal x terminal, without prices; infinite where there is none
    std::vector<double> reach_;   ///< option x terminal: from the option's exit
    std::vector<double> start_;   ///< by terminal: from `from`
    std::vector<double> price_;   ///< by terminal
    std::vector<double> merged_;  ///< stop x stop, with prices
    std::vector<int> touched_;    ///< stop x stop: which terminals: 2 * (of the first) + (of the second)
    double root_ = 0;
};

}  // namespace strandline::tour
