#pragma once
// Private to the room: the area as a coarse raster. Which ring rakes which sand, where two rings lie side by
// side, what is raked already, and the way over what is not.
#include "path/fill/rings.hpp"

namespace strandline::fill {

/// Cells of a quarter of the rake's width over the area's box; of half a width where that is very large.
struct Lattice {
    Point origin;
    double cell = 0;
    int columns = 0, rows = 0;
    std::vector<char> inside;  // of the area, by the cell's centre
    std::vector<int> owner;    // the ring nearest to the cell's centre, within three quarters of a width; -1
    std::vector<char> raked;   // 2; 1: its centre is not, but parts of it may be
};

/// Side by side: the number of cell edges that two rings share. first < second; sorted.
struct Contact {
    int first = 0, second = 0, edges = 0;
};

/// Widths squared of an area's box: in larger ones the cells are coarse and passes are not kept off raked
/// sand.
inline constexpr double largest_fine = 2e5;
/// Empty, with a warning, where that would be more than thirty million cells: then nothing counts as raked,
/// no rings touch, and all ways are straight. O(cells + ring length / cell).
Lattice lattice_of(const Region& region, const std::vector<Ring>& rings, const std::string& place,
                   const Options& options, Fill& account);
std::vector<Contact> contacts(const Lattice& lattice);
/// Marks what the rake covers on its way along a line.
void rake(Lattice& lattice, const Polyline& line, const Options& options);
bool is_raked(const Lattice& lattice, Point p);
/// Within the area and not raked; true everywhere where the lattice is empty.
bool is_free(const Lattice& lattice, Point p);
/// The shortest way from a to b that keeps off raked sand and stays inside, where there is one: A* over the
/// cells (Hart, Nilsson and Raphael 1968), eight neighbours, raked and outer cells at a price; then pulled
/// tight. Both ends left out.
Polyline way(const Lattice& lattice, Point from, Point to);

}  // namespace strandline::fill
