#include "path/tour/breed.hpp"

#include <algorithm>
#include <utility>

#include "path/tour/assembly.hpp"
#include "path/tour/climb.hpp"

namespace strandline::tour {
namespace {

/// Up to here annealing makes the members.
constexpr int most_annealed = 1'500;
/// Annealings in a budget: as many as share it well; fewer where each would be shorter than `fewest_kicks`
/// kicks a piece.
constexpr int most_annealings = 10;
constexpr double fewest_kicks = 2.5;
/// Losses kept at first, in mean legs.
constexpr double high_heat = 2, low_heat = 0.3;
/// Members that are kicked apart: below these, annealing is better; above, time goes into nothing new.
constexpr int fewest_members = 8, most_members = 60;
/// Of the span, for annealing the first member, and up to where the others are made; crossing takes the rest,
/// and what it leaves goes into annealing from the best.
constexpr double annealing_share = 0.2;
constexpr double making_share = 0.55;
constexpr int last_annealings = 3;
/// Where a member is so much longer than the annealed one, as in heaps of large elements, crossing does not
/// make up for it (measured: 8 % in a heap, 4 % among polygons, 2 % among lines).
constexpr double hopeless = 1.075;
/// Generations end by themselves, after 20 or 30.
constexpr int most_generations = 200;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Population {
  public:
    Population(Search& search, Descent& descent, Budget& budget)
        : search_(search), descent_(descent), budget_(budget) {}

    void add() {
        members_.push_back(search_.tour);
        lengths_.push_back(search_.tour.length());
    }
    std::size_t size() const { return members_.size(); }
    const Sequence& best() const {
        return members_[at(
            static_cast<int>(std::min_element(lengths_.begin(), lengths_.end()) - lengths_.begin()))];
    }
    /// Every member absorbs another, in random order, until none gains or the span is gone.
    void cross(Span span) {
        const int count = static_cast<int>(members_.size());
        std::vector<int> turn(at(count));
        for (int m = 0; m < count; ++m) turn[at(m)] = m;
        bool gained = count > 1;
        for (int g = 0; gained && g < most_generations; ++g) {
            gained = false;
            for (int k = count; k > 1; --k) std::swap(turn[at(k - 1)], turn[at(below(search_.random, k))]);
            const Sequence first = members_[at(turn[0])];
            for (int m = 0; m < count && !descent_.ended() && span.gone(budget_) < 1; ++m) {
                const int own = turn[at(m)];
                std::swap(search_.tour, members_[at(own)]);
                const Sequence& other = m + 1 < count ? members_[at(turn[at(m + 1)])] : first;
                const double gain = absorb(search_, descent_, other, vain_);
                std::swap(search_.tour, members_[at(own)]);
                lengths_[at(own)] -= gain;
                gained = gained || gain > 0;
            }
        }
    }

  private:
    Search& search_;
    Descent& descent_;
    Budget& budget_;
    std::vector<Sequence> members_;
    std::vector<double> lengths_;
    Vain vain_;
};

/// Annealings that the span has room for.
int annealings(const Model& model, const Budget& budget, Span span) {
    if (budget.progress.time_used) return most_annealings;
    const double kicks = (span.end - span.begin) * static_cast<double>(budget.moves);
    return std::clamp(static_cast<int>(kicks / (fewest_kicks * std::max(1, model.piece_count()))), 1,
                      most_annealings);
}

}  // namespace

std::vector<Visit> bred(const Model& model, const Candidates& near, const std::vector<Visit>& first,
                        std::uint64_t seed, Budget& budget, Span span, double member) {
    Search search{Sequence(model, first), near, std::mt19937_64(seed), {}, {}};
    Descent descent(search, budget);
    const double before = search.tour.length();
    Population population(search, descent, budget);
    // The second annealing begins where the first began: what both find is worth having.
    const auto anneal_on = [&](int from, int count, double heat) {
        for (int k = from; k < from + count && !descent.ended() && span.gone(budget) < 1; ++k) {
            search.tour = k < 2 ? Sequence(model, first) : population.best();
            const Span part{budget.used(), budget.used() + (span.end - budget.used()) / (from + count - k)};
            anneal(search, descent, budget, part, heat);
            population.add();
            population.cross(span);
        }
    };
    const bool many = !model.rules.any && model.piece_count() > most_annealed;
    if (!many) {
        const int count = model.rules.any ? 1 : annealings(model, budget, span);
        anneal_on(0, count, count == 1 ? low_heat : high_heat);
    } else if (making_share * (span.end - budget.used()) < fewest_members * member) {
        anneal_on(0, 1, low_heat);
    } else {
        anneal(search, descent, budget, span.part(0, annealing_share), low_heat);
        population.add();
        const double annealed = search.tour.length();
        const Span making = span.part(0, making_share);
        bool hopeful = true;
        while (hopeful && population.size() < most_members && making.gone(budget) < 1 && !descent.ended()) {
            search.tour = Sequence(model, first);
            diverge(search, descent);
            population.add();
            hopeful = search.tour.length() < hopeless * annealed;
        }
        population.cross(span);
        anneal_on(2, last_annealings, low_heat);
    }
    if (population.size() == 0) return first;
    search.tour = population.best();
    if (choose_all_vertices(search) > 0) search.touched.clear();
    return search.tour.length() < before ? search.tour.order() : first;
}

}  // namespace strandline::tour
