#include "path/tour/descent.hpp"

#include <algorithm>

namespace strandline::tour {
namespace {

/// Both ends of so many / 2 of the longest links.
constexpr int longest_count = 24;
/// Steps between two questions whether to stop.
constexpr int steps_between_polls = 256;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void find_longest(Search& search) {
    const Sequence& tour = search.tour;
    search.longest.clear();
    if (tour.model().loose_from == tour.nodes()) return;
    std::vector<std::pair<double, int>> links;
    for (int node = 0; node < tour.model().loose_from; ++node) links.emplace_back(-tour.link(node), node);
    const auto count = std::min<std::ptrdiff_t>(longest_count, static_cast<std::ptrdiff_t>(links.size()));
    std::partial_sort(links.begin(), links.begin() + count, links.end());
    for (std::ptrdiff_t k = 0; k < count; ++k)
        search.longest.push_back({links[static_cast<std::size_t>(k)].second, true, 0});
}

void Descent::push(int node) {
    if (waiting_[at(node)]) return;
    waiting_[at(node)] = true;
    queue_.push_back(node);
}

int Descent::pop() {
    if (head_ == queue_.size()) {
        queue_.clear();
        head_ = 0;
        return -1;
    }
    const int node = queue_[head_++];
    waiting_[at(node)] = false;
    return node;
}

double Descent::settle() {
    double gain = 0;
    for (std::size_t k = 0; k < search_.touched.size(); ++k) {
        const int node = search_.touched[k];
        push(node);
        if (!search_.tour.model().is_polygon(node / 2)) continue;
        push(node ^ 1);
        if (const double g = revertex_.evaluate(search_, node / 2); g > 0) {
            revertex_.apply(search_);
            push(search_.tour.mate(node));
            push(search_.tour.mate(node ^ 1));
            gain += g;
        }
    }
    search_.touched.clear();
    return gain;
}

template <class Move>
double Descent::run(Move& exchange, bool keep_log) {
    double gain = settle();
    for (int node = pop(); node >= 0 && !ended(); node = pop()) {
        double g = exchange.evaluate(search_, node);
        if (g > 0) {
            exchange.apply(search_);
        } else if (search_.tour.model().is_polygon(node / 2)) {
            g = reinsert_.evaluate(search_, node / 2);
            if (g > 0) reinsert_.apply(search_);
        }
        if (g > 0) gain += g + settle();
        if (!keep_log) search_.tour.forget();
        if (++budget_.steps % steps_between_polls == 0 && budget_.progress.stopped()) budget_.stopped = true;
    }
    if (ended())
        while (pop() >= 0) {
        }
    return gain;
}

double Descent::run() { return run(exchange_, true); }

double Descent::run_wide() { return run(wide_exchange_, false); }

void Descent::touch_all() {
    for (int place = 0; place < search_.tour.nodes(); ++place)
        search_.touched.push_back(search_.tour.node_at(place));
}

}  // namespace strandline::tour
