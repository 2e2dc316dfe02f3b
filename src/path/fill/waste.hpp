#pragma once
// Private to the room: what parallel lines waste in an area, estimated from its edges alone.
#include "path/fill/passes.hpp"

namespace strandline::fill {

struct Waste {
    double direction = 0;                                   ///< the best, radians
    double area = std::numeric_limits<double>::infinity();  ///< overlap and bare sand together, m^2
};
/// What a line costs by its turn, and a cut by the way over it and the ends of lines along it, m^2.
double line_cost(const Options& options);
double cut_cost(const Options& options);
/// A line that ends at an edge it meets at the angle a wastes about w^2/2 cot(a) there, or a share of it;
/// rows along an edge waste what the edge's distance from the rows' common raster is short of a row. Tried
/// are the directions of the longest edges, or the given one. O(directions x edges).
Waste least_waste(const Region& area, std::optional<double> direction, const Options& options);
/// The `most` best directions, best first.
std::vector<Waste> least_wastes(const Region& area, std::optional<double> direction, std::size_t most,
                                const Options& options);

}  // namespace strandline::fill
