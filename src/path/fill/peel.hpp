#pragma once
// Private to the room: in what order rings are raked.
#include "path/fill/lattice.hpp"

namespace strandline::fill {

/// Each ring is raked before its parent.
struct Tree {
    std::vector<int> parent;  // by ring; -1: a root
    int leaves = 0;
};
/// The tree of a connected peel from the outside in: whatever is not raked yet is one connected piece that
/// holds the way out. O(contacts x degree).
Tree tree_of(const std::vector<Ring>& rings, const Lattice& lattice);

/// Rings that lead on to each other, the first raked first, and the ring at which a later chain goes on; null
/// at the end.
struct Chain {
    std::vector<const Ring*> rings;
    const Ring* onward = nullptr;
};
using Peel = std::vector<Chain>;
/// The driving order: the reverse of the peel. Begins with the leaf nearest to `start`, if there is one.
/// O(rings x leaves).
Peel peel_of(const std::vector<Ring>& rings, const Tree& tree, std::optional<Point> start);

}  // namespace strandline::fill
