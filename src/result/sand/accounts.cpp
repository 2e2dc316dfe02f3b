#include "result/sand/accounts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace strandline::sand {
namespace {

/// More rows than any field has at a useful cell size: such an outline is a broken file, and only what is
/// laid is looked at.
constexpr double most_rows = 200'000;

/// Calls what(row, first, end) for the cells of `row` whose centres lie in the region: even-odd over all
/// outlines.
template <class What>
void for_rows(const Region& region, const Ground& ground, Box within, What what) {
    struct Edge {
        Point low, high;
    };
    std::vector<Edge> edges;
    const auto add = [&](const Polygon& outline) {
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const Point a = outline[k], b = outline[k + 1 == outline.size() ? 0 : k + 1];
            if (a.y != b.y) edges.push_back(a.y < b.y ? Edge{a, b} : Edge{b, a});
        }
    };
    add(region.outer);
    for (const Polygon& hole : region.holes) add(hole);
    std::ranges::sort(edges, {}, [](const Edge& e) { return e.low.y; });
    const Box box = bounds(region);
    const double low = std::max(box.low.y, within.low.y), high = std::min(box.high.y, within.high.y);
    const double cell = ground.cell_size();
    std::vector<Edge> active;
    std::vector<double> cuts;
    auto next = edges.begin();
    for (int row = ground.first_from(low), end = ground.first_from(high); row < end; ++row) {
        const double y = (row + 0.5) * cell;
        for (; next != edges.end() && next->low.y <= y; ++next) active.push_back(*next);
        std::erase_if(active, [&](const Edge& e) { return e.high.y <= y; });
        cuts.clear();
        for (const Edge& e : active)
            cuts.push_back(e.low.x + (e.high.x - e.low.x) * ((y - e.low.y) / (e.high.y - e.low.y)));
        std::ranges::sort(cuts);
        for (std::size_t k = 0; k + 1 < cuts.size(); k += 2)
            what(row, ground.first_from(cuts[k]), ground.first_from(cuts[k + 1]));
    }
}

const Region* region_of(const Element& element) {
    const auto* held = std::get_if<RegionElement>(&element.what);
    return held != nullptr ? &held->region : nullptr;
}

}  // namespace

Owners region_owners(const Plan& plan, double cell, Box laid) {
    Owners owners{Ground(cell)};
    if (laid.empty()) return owners;
    const int left = owners.ground.index(laid.low.x), right = owners.ground.index(laid.high.x) + 1;
    for (std::size_t e = 0; e < plan.drawing.elements.size(); ++e) {
        const Region* region = region_of(plan.drawing.elements[e]);
        if (region == nullptr || region->outer.size() < 3) continue;
        for_rows(*region, owners.ground, laid, [&](int row, int first, int end) {
            for (int i = std::max(first, left); i < std::min(end, right); ++i)
                owners.ground.at(i, row).element = static_cast<std::int32_t>(e);
        });
    }
    return owners;
}

Accounts region_accounts(const Plan& plan, const Ground& ground, Box laid) {
    Accounts accounts;
    const double cell_area = ground.cell_size() * ground.cell_size();
    for (std::size_t e = 0; e < plan.drawing.elements.size(); ++e) {
        const Region* region = region_of(plan.drawing.elements[e]);
        if (region == nullptr) continue;
        Account account{.element = static_cast<int>(e)};
        std::vector<BareRun> bare;
        if (region->outer.size() >= 3) {
            const Box box = bounds(*region);
            const bool countable = box.height() / ground.cell_size() < most_rows;
            const int left = laid.empty() ? 1 : ground.index(laid.low.x);
            const int right = laid.empty() ? 0 : ground.index(laid.high.x) + 1;
            for_rows(*region, ground, countable ? box : laid, [&](int row, int first, int end) {
                account.area += static_cast<double>(end - first) * cell_area;
                for (int i = std::max(first, left); i < std::min(end, right); ++i) {
                    const Cell* cell = ground.find(i, row);
                    if (cell == nullptr || cell->passes == 0) {
                        if (!bare.empty() && bare.back().row == row && bare.back().end == i)
                            ++bare.back().end;
                        else
                            bare.push_back({row, i, i + 1});
                        continue;
                    }
                    account.covered += cell_area;
                    account.overdraw += (cell->passes - 1) * cell_area;
                }
            });
            if (!countable) account.area = area(*region);
        }
        accounts.regions.push_back(account);
        std::ranges::move(bare_pieces(bare, ground, plan.robot.pin_pitch, account.element),
                          std::back_inserter(accounts.bare));
    }
    std::ranges::stable_sort(accounts.bare, std::greater{}, &Bare::area);
    return accounts;
}

}  // namespace strandline::sand
