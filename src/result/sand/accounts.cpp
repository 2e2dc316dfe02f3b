#include "result/sand/accounts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace strandline::sand {
namespace {

/// More rows than any field has at a useful cell size: such an outline is a broken file, and only what is
/// laid is looked at.
constexpr double most_rows = 200'000;

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
        for (const auto& [row, first, end] : runs_in(owners.ground, *region, laid))
            for (int i = std::max(first, left); i < std::min(end, right); ++i)
                owners.ground.at(i, row).element = static_cast<std::int32_t>(e);
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
        std::vector<RowRun> bare;
        if (region->outer.size() >= 3) {
            const Box box = bounds(*region);
            const bool countable = box.height() / ground.cell_size() < most_rows;
            const int left = laid.empty() ? 1 : ground.index(laid.low.x);
            const int right = laid.empty() ? 0 : ground.index(laid.high.x) + 1;
            for (const auto& [row, first, end] : runs_in(ground, *region, countable ? box : laid)) {
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
            }
            if (!countable) account.area = area(*region);
        }
        accounts.regions.push_back(account);
        for (const Patch& patch : patches(ground, bare))
            if (patch.width >= plan.robot.pin_pitch && patch.height >= plan.robot.pin_pitch)
                accounts.bare.push_back({patch.at, patch.area, account.element});
    }
    std::ranges::stable_sort(accounts.bare, std::greater{}, &Bare::area);
    return accounts;
}

}  // namespace strandline::sand
