#pragma once
// The search: order and entries for the least rake-up length. Open generalised TSP: every element once, never
// split; an open line is entered at either end, a closed one at any vertex and left there. Knows nothing of
// robots. See docs/tour.md.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/geometry/geometry.hpp"

namespace strandline::tour {

enum class Direction { any, forward, backward };  ///< open lines
enum class Sense { any, ccw, cw };                ///< closed lines

struct Element {
    bool closed = false;
    std::vector<Point> points;  ///< open: >= 2, only the ends matter to the length; closed: >= 3 (>= 1
                                ///< served), first not repeated
    std::optional<int> entry;   ///< fixed entry vertex
    Direction direction = Direction::any;
    Sense sense = Sense::any;
    std::string name;  ///< for messages; may be empty
};
/// Element i is left at (or entered from) its vertex v, and j follows (or precedes) at its vertex w, next to
/// each other.
struct Link {
    int element_a = 0, vertex_a = 0, element_b = 0, vertex_b = 0;
};
enum class End { free, at_point, at_start };
struct Problem {
    std::vector<Element> elements;
    std::optional<Point> start;
    End end = End::free;
    Point end_point;
    std::vector<Link> links;
    std::vector<std::pair<int, int>> before;  ///< first is finished before second begins
    std::vector<std::vector<int>> groups;     ///< drawn without others between
    bool keep_group_order = false;
};
struct Step {
    int element = 0, entry = 0;  ///< open: 0 forward, n-1 backward
    bool reversed = false;
    bool operator==(const Step&) const = default;
};
/// best: a search, and a proof where it can be had. exact: the optimum, or an error. The others are what
/// there is without a search, to compare with: nearest neighbour with reversal, and the order of the file,
/// each element as it is drawn (as far as the rules allow).
enum class Method { best, exact, nearest, file };
std::optional<Method> method_named(std::string_view name);
struct Options {
    Method method = Method::best;
    bool grouped = false;  ///< neighbouring elements are finished together
    int threads = 1;       ///< so many searches, with seeds from `seed` on; the best is taken
    std::uint64_t seed = 1;
    /// budget, about so many kicks with their repairs; 0: chosen from the size (a second at 1,000 elements).
    /// Progress::time_used, where it is set, takes its place.
    std::uint64_t moves = 0;
};
struct Tour {
    std::vector<Step> steps;
    double length = 0;  ///< recounted: start leg, legs between, end leg
    bool proven_optimal = false;
    std::uint64_t moves = 0;               ///< of the budget, used
    std::vector<std::vector<int>> groups;  ///< grouped: what is finished together, in no certain order
    double ungrouped = 0;                  ///< grouped: the length without that
    bool stopped = false;  ///< ended by progress.stopped() or planned by its time limit: not reproducible
};
/// Error: contradictory constraints by name, non-finite points, element without points; with Method::exact
/// also where no proof is found within a minute or so. Deterministic for seed, moves and threads, unless
/// stopped or within a time limit (the caller's: this room reads no clock). About 30 us a move, O(n threads)
/// memory. The progress is asked by one thread at a time.
Outcome<Tour> solve(const Problem& problem, const Options& options = {}, const Progress& progress = {});
/// Where each element is entered when a closed one may be entered anywhere on its edges.
struct Entries {
    std::vector<Point> at;  ///< by step; of an open element: the end it is entered at
    double length = 0;      ///< of the legs between, never longer than from vertex to vertex
};
/// For that order: one entry after the other is put where the legs beside it are shortest (a mirror's law on
/// each edge), until none gains. Fixed and linked entries stay. `steps` as of a Tour. O(rounds x points).
Entries entered_on_edges(const Problem& problem, const std::vector<Step>& steps);
/// Recount of a given order: Error when it is not valid for the problem (which step, why).
Outcome<double> recount(const Problem& problem, const std::vector<Step>& steps);

}  // namespace strandline::tour
