#include "path/tour/exact.hpp"

#include <algorithm>

#include "path/tour/gates.hpp"
#include "path/tour/programme.hpp"

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Rounding: bounds and costs are sums of some dozens of terms.
constexpr double slack_share = 1e-10;

Route build_route(const Model& model, const Gates& gates) {
    Route route;
    for (int p = 0; p < model.piece_count(); ++p) {
        const Piece& piece = model.pieces[at(p)];
        route.first.push_back(static_cast<int>(route.options.size()));
        route.polygon.push_back(piece.choices > 0 || model.ends[at(2 * p)] == model.ends[at(2 * p + 1)]);
        for (int c = 0; c < piece.choices; ++c) {
            const Point v = model.choices[at(piece.first_choice + c)].at;
            route.options.push_back({p, false, c, v, v});
        }
        for (const bool backward : {false, true})
            if (piece.choices == 0 && gates.ways[at(2 * p + backward)].open)
                route.options.push_back(
                    {p, backward, 0, model.ends[at(2 * p + backward)], model.ends[at(2 * p + 1 - backward)]});
        route.all |= bit(p);
    }
    route.first.push_back(static_cast<int>(route.options.size()));
    return route;
}

}  // namespace

std::optional<std::vector<Visit>> prove(const Model& model, const std::vector<Visit>& known, double upper,
                                        std::uint64_t work, const Progress& progress) {
    if (model.piece_count() > most_exact_pieces) return std::nullopt;
    if (model.pieces.empty()) return known;
    const Gates gates = build_gates(model);
    const Route route = build_route(model, gates);
    const double slack = std::max(model.tolerance, slack_share * upper);
    std::vector<Visit> best = known;
    Work left{work};
    if (model.gate) {
        Route open = route;
        const Problem& problem = *model.problem;
        if (problem.start) open.from = &model.ends[at(model.gate_start)];
        if (problem.end != End::free) open.to = &model.ends[at(model.gate_end)];
        const auto found = shortest(gates, std::move(open), -1, upper, slack, left, progress);
        if (!found.empty()) best = found;
    } else {
        // A ring: opened at one piece, in each way of passing it. Rules count from the first piece, so then
        // every piece may be it.
        int fewest = 0;
        for (int p = 1; p < model.piece_count(); ++p)
            if (route.first[at(p + 1)] - route.first[at(p)] <
                route.first[at(fewest + 1)] - route.first[at(fewest)])
                fewest = p;
        for (int p = 0; p < model.piece_count() && !left.spent; ++p) {
            if (!model.rules.any && p != fewest) continue;
            for (int o = route.first[at(p)]; o < route.first[at(p + 1)] && !left.spent; ++o) {
                const Option& lead = route.options[at(o)];
                const int way = 2 * p + (lead.backward ? 1 : 0);
                if (!gates.lets(0, -1, way)) continue;
                if (model.piece_count() == 1) {
                    const double length = distance(lead.out, lead.in);
                    if (length < upper - slack) {
                        upper = length;
                        best = {{p, lead.backward, lead.choice}};
                    }
                    continue;
                }
                Route rest = route;
                rest.all &= ~bit(p);
                rest.from = &lead.out;
                rest.to = &lead.in;
                const auto found = shortest(gates, std::move(rest), way, upper, slack, left, progress);
                if (found.empty()) continue;
                best = {{p, lead.backward, lead.choice}};
                best.insert(best.end(), found.begin(), found.end());
            }
        }
    }
    if (left.spent) return std::nullopt;
    return best;
}

}  // namespace strandline::tour
