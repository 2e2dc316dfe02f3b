#pragma once
// Private to the room: in what order rings are raked.
#include "path/fill/lattice.hpp"

namespace strandline::fill {

/// Rings that lead on to each other, the first raked first, and the ring at which a later chain goes on; null
/// at the end.
struct Chain {
    std::vector<const Ring*> rings;
    const Ring* onward = nullptr;
};
using Peel = std::vector<Chain>;
/// The driving order: the reverse of a connected peel from the outside in, so whatever is not raked yet is
/// one connected piece that holds the way out. Begins with the leaf nearest to `start`, if there is one.
/// O(contacts x degree).
Peel peel_of(const std::vector<Ring>& rings, const Lattice& lattice, std::optional<Point> start);

}  // namespace strandline::fill
