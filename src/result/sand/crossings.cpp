#include "result/sand/crossings.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::sand {
namespace {

/// Metres: a few steps of samples.
constexpr double square = 0.1;

std::uint64_t key_of(int i, int j) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32) | static_cast<std::uint32_t>(j);
}
int square_of(double coordinate) { return static_cast<int>(std::floor(coordinate / square)); }

template <class What>
void for_squares(Point a, Point b, What what) {
    for (int i = square_of(std::min(a.x, b.x)); i <= square_of(std::max(a.x, b.x)); ++i)
        for (int j = square_of(std::min(a.y, b.y)); j <= square_of(std::max(a.y, b.y)); ++j)
            what(key_of(i, j));
}

}  // namespace

void DrawnLines::add(const DrawnPiece& piece) {
    const int number = static_cast<int>(pieces_.size());
    pieces_.push_back(piece);
    for_squares(piece.from, piece.to, [&](std::uint64_t key) { squares_[key].push_back(number); });
}

std::vector<LineCrossing> DrawnLines::crossed(Point a, Point b) const {
    std::vector<int> near;
    for_squares(a, b, [&](std::uint64_t key) {
        if (const auto found = squares_.find(key); found != squares_.end())
            near.insert(near.end(), found->second.begin(), found->second.end());
    });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::vector<LineCrossing> met;
    for (int number : near) {
        const DrawnPiece& piece = pieces_[static_cast<std::size_t>(number)];
        const auto hit = crossing(a, b, piece.from, piece.to);
        if (hit && hit->s < 1 && hit->t < 1) met.push_back({hit->at, piece.element});
    }
    return met;
}

}  // namespace strandline::sand
