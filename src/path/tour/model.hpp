#pragma once
// The problem as the search sees it. A *piece* is what is never split: one element, or a chain of linked
// ones. Piece i has two nodes, 2i and 2i+1, and the edge between them cannot be removed. A line's nodes are
// its ends; a polygon's two nodes lie on one point, the vertex now chosen. One more piece, the *gate*, stands
// for start and end and closes the path into a ring; its *loose* nodes (no start, or no end given) are at
// distance 0 from everything. A closed tour with a free start has no gate.
#include <utility>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/geometry/geometry.hpp"
#include "path/tour/tour.hpp"

namespace strandline::tour {

/// An element inside its piece, as met when the piece is run from node 2i to node 2i+1.
struct Member {
    int element, entry, exit;
};

struct Piece {
    std::vector<Member> members;  ///< one or more; a polygon with a choice of vertices is alone in its piece
    int first_choice = 0;         ///< its vertices: Model::choices from here ...
    int choices = 0;              ///< ... so many; 0: both nodes are fixed
    int direction = 0;            ///< +1: only from 2i to 2i+1; -1: only back; 0: either
};

/// A vertex that a polygon may be entered at.
struct Choice {
    Point at;
    int vertex;
};

/// What binds the order beyond the chains. All by element.
struct Rules {
    bool any = false;       ///< false: every order is allowed, no check is made
    bool directed = false;  ///< some piece has a direction
    std::vector<std::pair<int, int>> before;
    std::vector<int> group_of;  ///< by element; -1: none
    std::vector<int> group_size;
    bool keep_group_order = false;
};

struct Model {
    const Problem* problem = nullptr;
    std::vector<Piece> pieces;  ///< without the gate
    std::vector<Choice> choices;
    std::vector<Point> ends;    ///< by node, gate included; polygons: their first choice
    std::vector<int> piece_of;  ///< by element
    bool gate = true;
    int gate_start = 0, gate_end = 0;  ///< nodes: the drive begins at the one and ends at the other
    int loose_from = 0;                ///< nodes from here on are loose
    Rules rules;
    double tolerance = 0;  ///< gains below this are rounding

    int piece_count() const { return static_cast<int>(pieces.size()); }
    int node_count() const { return static_cast<int>(ends.size()); }
    bool is_polygon(int piece) const {
        return piece < piece_count() && pieces[static_cast<std::size_t>(piece)].choices > 0;
    }
};

/// "element 3 (eye)".
std::string named(const Problem& problem, int element);
/// Refuses by name what is broken in itself: points, vertex numbers, links, groups. Keeps a pointer to
/// `problem`.
Outcome<Model> build_model(const Problem& problem);

/// A piece in the order of the drive. backward: from node 2i+1 to node 2i. choice: of a polygon, counted
/// within the piece.
struct Visit {
    int piece = 0;
    bool backward = false;
    int choice = 0;
};
/// Whether the order keeps the rules. O(n + rules).
bool keeps_rules(const Model& model, const std::vector<Visit>& order);
std::vector<Step> steps_of(const Model& model, const std::vector<Visit>& order);
/// Where a step begins and ends.
Point entry_of(const Problem& problem, const Step& step);
Point exit_of(const Problem& problem, const Step& step);
/// Straight rake-up length of the steps, without any check.
double length_of(const Problem& problem, const std::vector<Step>& steps);

}  // namespace strandline::tour
