#include "path/tour/moves.hpp"

namespace strandline::tour {
namespace {

/// How many candidates are tried at each depth: wide where it is cheap, narrow where branches multiply.
constexpr int breadth[most_links] = {0, 5, 3, 2, 1};
/// The most of them.
constexpr int widest = 5;
/// The gate has two nodes.
constexpr int most_loose = 2;
/// Depth to which a join with a loose node is followed up.
constexpr int deepest_loose = 1;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

double Exchange::evaluate(Search& search, int node) {
    t_[0] = node;
    t_[1] = search.tour.mate(node);
    return deeper(search, 1, search.tour.link(node));
}

double Exchange::deeper(Search& search, int k, double gain) {
    Sequence& tour = search.tour;
    const Model& model = tour.model();
    const double tolerance = model.tolerance;
    const int last = t_[2 * k - 1];
    const auto& lists = search.candidates;
    const bool loose = last >= model.loose_from;
    const Candidates::Near* near = loose ? search.longest.data() : lists.all.data() + lists.first[at(last)];
    const Candidates::Near* end =
        loose ? near + search.longest.size() : lists.all.data() + lists.first[at(last + 1)];
    struct Try {
        int node, mate;
        double open;
    };
    // Loose nodes come first in every list and cost nothing: they are tried beside the best, not instead of
    // them.
    Try tries[widest + most_loose];
    int count = 0, loose_count = 0;
    for (; near != end; ++near) {
        const auto [node, exact, least] = *near;
        if (gain - least <= tolerance) break;  // the lists are sorted
        const double left = gain - (exact ? least : tour.gap(last, node));
        if (left <= tolerance) continue;
        bool taken = false;
        for (int i = 0; i < 2 * k; ++i) taken = taken || t_[i] == node;
        if (taken) continue;
        const int mate = tour.mate(node);
        const double open = left + tour.link(node);
        if (node >= model.loose_from) {
            tries[widest + loose_count++] = {node, mate, open};
            continue;
        }
        if (count == breadth[k] && tries[count - 1].open >= open) continue;
        int place = count < breadth[k] ? count++ : count - 1;
        for (; place > 0 && tries[place - 1].open < open; --place) tries[place] = tries[place - 1];
        tries[place] = {node, mate, open};
    }
    for (int i = 0; i < count + loose_count; ++i) {
        const bool has_place = i < count;
        const auto [node, mate, open] = tries[has_place ? i : widest + i - count];
        t_[2 * k] = node;
        t_[2 * k + 1] = mate;
        const double closed = open - tour.gap(mate, t_[0]);
        if (closed > tolerance && tour.closes(t_, k + 1)) {
            k_ = k + 1;
            if (!model.rules.any) return closed;
            const std::size_t mark = tour.mark();
            tour.exchange(t_, k_);
            const bool allowed = tour.keeps_rules();
            tour.back(mark);
            if (allowed) return closed;
        }
        if (k + 1 < most_links && (has_place || k <= deepest_loose))
            if (const double found = deeper(search, k + 1, open); found > 0) return found;
    }
    return 0;
}

void Exchange::apply(Search& search) const {
    search.tour.exchange(t_, k_);
    search.touched.insert(search.touched.end(), t_, t_ + 2 * k_);
}

}  // namespace strandline::tour
