#include "path/tour/moves.hpp"

namespace strandline::tour {
namespace {

/// Links it takes out, in one circle.
constexpr int three[] = {3};

}  // namespace

double Reinsert::evaluate(Search& search, int piece) {
    Sequence& tour = search.tour;
    const Model& model = tour.model();
    if (!model.is_polygon(piece) || tour.nodes() < 6) return 0;  // with two pieces there is no other place
    const int a = 2 * piece, b = a + 1;
    const int before = tour.mate(a), after = tour.mate(b);
    const double freed = tour.gap(before, a) + tour.gap(b, after) - tour.gap(before, after);
    if (freed <= model.tolerance) return 0;
    const Piece& own = model.pieces[static_cast<std::size_t>(piece)];
    const Candidates& near = search.candidates;
    double best = 0;
    for (int c = near.first[static_cast<std::size_t>(a)]; c < near.first[static_cast<std::size_t>(a + 1)];
         ++c) {
        const auto [node, exact, least] = near.all[static_cast<std::size_t>(c)];
        if (least >= freed) break;
        const int mate = tour.mate(node);
        if (mate / 2 == piece || node / 2 == piece) continue;
        const double link = tour.link(node);
        for (int v = 0; v < own.choices; ++v) {
            const Point p = model.choices[static_cast<std::size_t>(own.first_choice + v)].at;
            const double there = (node >= model.loose_from ? 0 : distance(tour.at(node), p)) +
                                 (mate >= model.loose_from ? 0 : distance(p, tour.at(mate)));
            const double gain = freed + link - there;
            if (gain <= best + model.tolerance) continue;
            const int t[6] = {before, a, node, mate, b, after};
            if (model.rules.any) {
                const std::size_t mark = tour.mark();
                tour.exchange({t, three});
                const bool allowed = tour.keeps_rules();
                tour.back(mark);
                if (!allowed) break;
            }
            best = gain;
            piece_ = piece;
            choice_ = v;
            std::copy(t, t + 6, t_);
        }
    }
    return best;
}

void Reinsert::apply(Search& search) const {
    search.tour.exchange({t_, three});
    search.tour.choose(piece_, choice_);
    search.touched.insert(search.touched.end(), t_, t_ + 6);
}

}  // namespace strandline::tour
