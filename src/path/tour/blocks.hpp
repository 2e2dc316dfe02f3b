#pragma once
// What the rules tie together: see order.hpp for the words block, item, inside.
#include <utility>
#include <vector>

#include "path/tour/model.hpp"

namespace strandline::tour {

/// A chain that leads out of a group, or the inside of a group: its pieces that lie wholly in it.
struct Item {
    int piece = -1, group = -1;
    bool backward = false;
};
struct Block {
    std::vector<Item> items;
    bool runs[2] = {true, true};  ///< as listed; the other way round
};
struct Blocks {
    std::vector<Block> blocks;
    std::vector<int> block_of, item_of;      ///< by piece
    std::vector<std::vector<int>> inside;    ///< by group
    std::vector<int> block_of_group;         ///< -1: the group lies in a single piece
    std::vector<std::pair<int, int>> edges;  ///< between blocks
};

/// Rows of chains and groups, each from one of its ends. Refuses links that lead out of groups in ways that
/// no order has.
Outcome<Blocks> build_blocks(const Model& model);
/// Settles which way blocks can run, and refuses rules that no order can keep, naming the elements.
Outcome<void> check_blocks(const Model& model, Blocks& all);

}  // namespace strandline::tour
