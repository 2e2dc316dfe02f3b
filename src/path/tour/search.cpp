#include "path/tour/search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "path/tour/moves.hpp"

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Owners in a candidate list. Ten rather than eight: clusters and drawings with doubled lines need the room.
constexpr int candidate_count = 10;
constexpr std::uint64_t fewest_default_kicks = 16'000, most_default_kicks = 60'000;
/// Small enough that a proof is tried, so a short search will do.
constexpr std::uint64_t few_pieces = 40;
/// A loss of so many mean legs is accepted with chance 1/e at first, then less, and none in the last tenth of
/// a round.
constexpr double first_heat = 1, heated_share = 0.9;
constexpr int most_heated = 20'000;
/// Both ends of so many / 2 of the longest links.
constexpr int longest_count = 24;
/// Descent steps between two questions whether to stop.
constexpr int steps_between_polls = 256;

/// Nodes whose links are to be looked at, each once.
class Queue {
  public:
    explicit Queue(int nodes) : waiting_(at(nodes), false) {}
    void push(int node) {
        if (waiting_[at(node)]) return;
        waiting_[at(node)] = true;
        nodes_.push_back(node);
    }
    int pop() {
        if (head_ == nodes_.size()) {
            nodes_.clear();
            head_ = 0;
            return -1;
        }
        const int node = nodes_[head_++];
        waiting_[at(node)] = false;
        return node;
    }
    void clear() {
        while (pop() >= 0) {
        }
    }

  private:
    std::vector<bool> waiting_;
    std::vector<int> nodes_;
    std::size_t head_ = 0;
};

/// The nodes at the ends of the longest links: where a loose end is best put.
void find_longest(Search& search) {
    const Sequence& tour = search.tour;
    search.longest.clear();
    if (tour.model().loose_from == tour.nodes()) return;
    std::vector<std::pair<double, int>> links;
    for (int node = 0; node < tour.model().loose_from; ++node)
        links.emplace_back(-tour.gap(node, tour.mate(node)), node);
    const auto count = std::min<std::ptrdiff_t>(longest_count, static_cast<std::ptrdiff_t>(links.size()));
    std::partial_sort(links.begin(), links.begin() + count, links.end());
    for (std::ptrdiff_t k = 0; k < count; ++k)
        search.longest.push_back({links[static_cast<std::size_t>(k)].second, true, 0});
}

/// In (0, 1].
double uniform(std::mt19937_64& random) {
    constexpr double steps = 9007199254740992.0;  // 2^53: the doubles of one binade
    return (static_cast<double>(random() >> 11) + 1) / steps;
}

class Descent {
  public:
    Descent(Search& search, const Progress& progress, std::uint64_t most_visits)
        : search_(search), progress_(progress), most_visits_(most_visits), queue_(search.tour.nodes()) {}

    /// Every polygon whose links changed is entered anew; all that was touched is queued. The gain.
    double settle() {
        double gain = 0;
        for (std::size_t k = 0; k < search_.touched.size(); ++k) {
            const int node = search_.touched[k];
            queue_.push(node);
            if (!search_.tour.model().is_polygon(node / 2)) continue;
            queue_.push(node ^ 1);
            if (const double g = revertex_.evaluate(search_, node / 2); g > 0) {
                revertex_.apply(search_);
                queue_.push(search_.tour.mate(node));
                queue_.push(search_.tour.mate(node ^ 1));
                gain += g;
            }
        }
        search_.touched.clear();
        return gain;
    }

    /// Until no move gains. keep_log: so that the caller can take it back.
    double run(bool keep_log) {
        double gain = settle();
        for (int node = queue_.pop(); node >= 0 && !ended(); node = queue_.pop()) {
            double g = exchange_.evaluate(search_, node);
            if (g > 0) {
                exchange_.apply(search_);
            } else if (search_.tour.model().is_polygon(node / 2)) {
                g = reinsert_.evaluate(search_, node / 2);
                if (g > 0) reinsert_.apply(search_);
            }
            if (g > 0) gain += g + settle();
            if (!keep_log) search_.tour.forget();
            if (++steps_ % steps_between_polls == 0) stopped_ = progress_.stopped();
        }
        if (ended()) queue_.clear();
        return gain;
    }

    bool stopped() const { return stopped_; }
    bool ended() const { return stopped_ || search_.tour.visits_read > most_visits_; }
    void touch_all() {
        for (int place = 0; place < search_.tour.nodes(); ++place)
            search_.touched.push_back(search_.tour.node_at(place));
    }

  private:
    Search& search_;
    const Progress& progress_;
    const std::uint64_t most_visits_;
    Queue queue_;
    Exchange exchange_;
    Reinsert reinsert_;
    Revertex revertex_;
    std::uint64_t steps_ = 0;
    bool stopped_ = false;
};

}  // namespace

std::uint64_t default_kicks(int pieces) {
    // Up to a few hundred pieces well under a second, 1,000 in one second, a few seconds beyond.
    const auto n = static_cast<std::uint64_t>(std::max(pieces, 1));
    return n <= few_pieces ? 50 * n : std::clamp(30 * n, fewest_default_kicks, most_default_kicks);
}

Searched improve(const Model& model, const std::vector<Visit>& first, std::uint64_t seed, std::uint64_t kicks,
                 const Progress& progress, std::uint64_t most_visits) {
    const Candidates candidates = find_candidates(model, candidate_count);
    Search search{Sequence(model, first), candidates, std::mt19937_64(seed), {}, {}};
    Sequence& tour = search.tour;
    Descent descent(search, progress, most_visits);
    choose_all_vertices(search);
    find_longest(search);
    descent.touch_all();
    descent.run(false);
    if (choose_all_vertices(search) > 0) descent.run(false);
    tour.forget();

    Searched result;
    double length = tour.length(), best = length;
    // What is accepted beyond a gain: in every round of kicks a loss that shrinks to nothing, in shares of
    // the mean leg. Leaving the best costs a copy of it, so very large tours only go downhill.
    const bool heated = model.piece_count() <= most_heated;
    const double leg = heated ? length / std::max(1, tour.nodes() / 2) : 0;
    std::uint64_t round_begin = 0, round_size = std::min(kicks, default_kicks(model.piece_count()));
    std::vector<Visit> kept;
    bool away = false;  // from the best, which is then in `kept`
    Bridge bridge;
    const bool can_kick = tour.nodes() >= 8;
    const auto renewal = static_cast<std::uint64_t>(tour.nodes());
    const std::uint64_t reports = std::max<std::uint64_t>(1, std::min<std::uint64_t>(kicks / 100, 10'000));
    for (; can_kick && result.moves < kicks && !descent.ended(); ++result.moves) {
        if (result.moves % reports == 0)
            progress.report(fmt::format("rake up {:.6g}", best),
                            static_cast<double>(result.moves) / static_cast<double>(kicks));
        if (result.moves % renewal == 0) find_longest(search);
        if (result.moves - round_begin >= round_size) {
            round_begin = result.moves;
            round_size *= 2;
        }
        const double share =
            static_cast<double>(result.moves - round_begin) / static_cast<double>(round_size);
        const double heat = first_heat * leg * std::max(0.0, 1 - share / heated_share);
        double gain = bridge.evaluate(search);
        bridge.apply(search);
        if (!tour.keeps_rules()) {
            search.touched.clear();
            tour.back(0);
            continue;
        }
        gain += descent.run(true);
        const double allowed = heat * std::log(uniform(search.random));
        if (gain < 0 && gain < allowed) {
            tour.back(0);
            continue;
        }
        if (gain > model.tolerance) {
            for (int i = 0; i < 8; ++i) gain += choose_vertices_around(search, bridge.nodes()[i] / 2);
            gain += descent.run(true);
        }
        if (gain < -model.tolerance && !away) {
            // The best is left: it is what was there before this kick.
            const auto here = tour.order();
            tour.back(0);
            kept = tour.order();
            const std::uint64_t read = tour.visits_read;
            tour = Sequence(model, here);
            tour.visits_read = read;
            away = true;
        }
        length -= gain;
        if (length < best - model.tolerance) {
            best = length;
            away = false;
        }
        tour.forget();
    }
    if (away) tour = Sequence(model, kept);
    if (choose_all_vertices(search) > 0) search.touched.clear();
    length = tour.length();
    progress.report(fmt::format("rake up {:.6g}", length), 1);
    result.stopped = descent.stopped();
    result.order = tour.order();
    return result;
}

}  // namespace strandline::tour
