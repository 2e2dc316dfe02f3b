#include <algorithm>

#include "path/tour/moves.hpp"

namespace strandline::tour {
namespace {

/// The gate has two nodes.
constexpr int most_loose = 2;
/// Depth to which a join with a loose node is followed up.
constexpr int deepest_loose = 1;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

template <const int* breadth>
double Exchange<breadth>::evaluate(Search& search, int node) {
    Sequence& tour = search.tour;
    t_[0] = node;
    t_[1] = tour.mate(node);
    tour.mark_node(t_[0], true);
    tour.mark_node(t_[1], true);
    const double gain = this->template deeper<1>(search, tour.link(node));
    tour.mark_node(t_[0], false);
    tour.mark_node(t_[1], false);
    return gain;
}

template <const int* breadth>
template <int k>
double Exchange<breadth>::deeper(Search& search, double gain) {
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
        int node;
        double open;
    };
    // Loose nodes come first in every list and cost nothing: they are tried beside the best, not instead of
    // them.
    Try tries[breadth[k] + most_loose];
    int count = 0, loose_count = 0;
    for (; near != end; ++near) {
        const auto [node, exact, least] = *near;
        if (gain - least <= tolerance) break;  // the lists are sorted
        if (tour.marked(node)) continue;
        const double left = exact ? gain - least : gain - tour.gap(last, node);
        if (!exact && left <= tolerance) continue;
        const double open = left + tour.link(node);
        if (node >= model.loose_from) {
            tries[breadth[k] + loose_count++] = {node, open};
        } else if constexpr (breadth[k] == 1) {
            if (count == 0 || open > tries[0].open) tries[0] = {node, open};
            count = 1;
        } else {
            if (count == breadth[k] && tries[count - 1].open >= open) continue;
            int place = count < breadth[k] ? count++ : count - 1;
            for (; place > 0 && tries[place - 1].open < open; --place) tries[place] = tries[place - 1];
            tries[place] = {node, open};
        }
    }
    for (int i = 0; i < count + loose_count; ++i) {
        const bool has_place = i < count;
        const auto [node, open] = tries[has_place ? i : breadth[k] + i - count];
        const int mate = tour.mate(node);
        t_[2 * k] = node;
        t_[2 * k + 1] = mate;
        const double closed = open - tour.gap(mate, t_[0]);
        if (closed > tolerance && tour.closes(t_, k + 1) && allowed(search, k + 1)) {
            k_ = k + 1;
            return closed;
        }
        if constexpr (k + 1 < most_links) {
            if (!has_place && k > deepest_loose) continue;
            tour.mark_node(node, true);
            tour.mark_node(mate, true);
            const double found = deeper<k + 1>(search, open);
            tour.mark_node(node, false);
            tour.mark_node(mate, false);
            if (found > 0) return found;
        }
    }
    return 0;
}

template <const int* breadth>
bool Exchange<breadth>::allowed(Search& search, int k) const {
    Sequence& tour = search.tour;
    if (!tour.model().rules.any) return true;
    const std::size_t mark = tour.mark();
    tour.exchange({{t_, at(2 * k)}, {&k, 1}});
    const bool kept = tour.keeps_rules();
    tour.back(mark);
    return kept;
}

template <const int* breadth>
void Exchange<breadth>::apply(Search& search) const {
    search.tour.exchange({{t_, at(2 * k_)}, {&k_, 1}});
    search.touched.insert(search.touched.end(), t_, t_ + 2 * k_);
}

template class Exchange<narrow>;
template class Exchange<wide>;

}  // namespace strandline::tour
