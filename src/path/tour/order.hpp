#pragma once
// Orders that keep every rule: the proof that there is one, and the first of them, by nearest neighbour.
#include <vector>

#include "path/tour/model.hpp"

namespace strandline::tour {

/// Nearest neighbour with reversal, within the rules: from the start, or from the first piece that may come
/// first. Refuses rules that no order can keep, naming the elements. Without rules O(n log n); with rules
/// O(n^2).
///
/// With rules: groups and the chains that lead out of them form *blocks*, a row of items (a chain, the inside
/// of a group, a chain ...) that can be run one way or the other. Rules can be kept if every block has a way
/// to run, the inside of every group is free of circles, and so are the blocks among each other; then nearest
/// neighbour over what is ready never gets stuck.
Outcome<std::vector<Visit>> first_order(const Model& model);
/// The order of the file within the rules, each piece as it is drawn. O(n), with rules O(n^2).
Outcome<std::vector<Visit>> file_order(const Model& model);
/// Without rules only: kd-tree, O(n log n).
std::vector<Visit> nearest_order(const Model& model);

/// Edges of one circle in a directed graph, in order; empty when there is none. O(nodes + edges).
std::vector<std::size_t> find_circle(int nodes, const std::vector<std::pair<int, int>>& edges);

}  // namespace strandline::tour
