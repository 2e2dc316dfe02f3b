#pragma once
// Regions on the raster: which cells are theirs, and what became of them.
#include "result/sand/sand.hpp"

namespace strandline::sand {

/// Which region each touched cell belongs to (Cell::element, -1: none).
struct Owners {
    Ground ground;
    int at(int i, int j) const {
        const Cell* cell = ground.find(i, j);
        return cell != nullptr ? cell->element : -1;
    }
};
/// The regions' cells within `laid`. Of overlapping regions the later owns the cell. O(cells + rows x
/// corners).
Owners region_owners(const Plan& plan, double cell, Box laid);
/// What became of every region.
struct Accounts {
    std::vector<Account> regions;  ///< regions outside `laid` keep their exact area
    std::vector<Bare> bare;        ///< within `laid`, largest first
};
Accounts region_accounts(const Plan& plan, const Ground& ground, Box laid);

}  // namespace strandline::sand
