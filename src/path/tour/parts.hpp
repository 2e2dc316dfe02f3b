#pragma once
// A large problem in parts: neighbouring pieces as a problem of their own, the drive between them kept.
#include <vector>

#include "path/tour/model.hpp"
#include "path/tour/near.hpp"

namespace strandline::tour {

/// Pieces near each other, at most `most` a part: columns of equal count, each cut into cells of equal count
/// (Karp, Mathematics of Operations Research 2, 1977, in strips). shift: 0 to below 1, of a column and of a
/// cell, so that what was an edge comes to lie inside. O(n log n).
std::vector<std::vector<int>> parts_of(const Model& model, int most, double shift);

/// One part: its own pieces, and each stretch of the drive outside as one more piece that cannot be split.
/// The gate belongs to every part. No rules.
struct Part {
    Model model;
    Candidates near;
    std::vector<Visit> order;                    ///< the part's share of the order it was cut from
    std::vector<int> own;                        ///< by piece: that of the whole; -1: a stretch
    std::vector<std::pair<int, int>> stretches;  ///< by piece: places in the order, first and last; own: none
};
/// `pieces` of the whole, in any order. O(n).
Part part_of(const Model& model, const Candidates& near, const std::vector<Visit>& order,
             const std::vector<int>& pieces);
/// The whole order with the part's own new one in it. O(n).
std::vector<Visit> put_back(const Model& model, const Part& part, const std::vector<Visit>& found,
                            const std::vector<Visit>& order);

}  // namespace strandline::tour
