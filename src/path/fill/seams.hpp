#pragma once
// Private to the room: where each ring of a chain is begun and ended.
#include "path/fill/lattice.hpp"

namespace strandline::fill {

/// How a ring or spine is gone through.
struct Seam {
    double start = 0, span = 0;  // arc length; span < 0: against the ring's own sense
    bool corner = false;         // begun and ended at a corner that is cut
    bool stepped = false;        // reached with the rake down, by a step from the ring before
    bool flipped = false;        // a comb whose first tooth is raked from its end
};

/// Seams for rings that lead on to each other, so that few of the joints between them are hops: the cheapest
/// choice over candidate places (cut corners, places beside the next ring, and what lies beside those of the
/// ring before), by dynamic programming along the chain. `onward`: the ring at which a later chain goes on;
/// null at the end. `from`: where the vehicle stands; `exit`: where it is to be at the end, if anywhere.
/// `lattice`: what is raked already, and no good place to leave a ring over.
/// O(rings x candidates x (candidates + corners)).
std::vector<Seam> seams_of(const std::vector<const Ring*>& chain, const Ring* onward,
                           std::optional<Point> from, std::optional<Point> exit, const Lattice& lattice,
                           const Options& options);

/// The ring's passes by its seam: one, or more where corners are cut.
std::vector<Polyline> passes_along(const Ring& ring, const Seam& seam, const Options& options);

}  // namespace strandline::fill
