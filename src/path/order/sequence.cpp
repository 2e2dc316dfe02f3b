#include <algorithm>
#include <cmath>
#include <limits>

#include "path/order/annealer.hpp"

namespace strandline::order {
namespace {

/// Groups beside which a group is tried.
constexpr std::size_t most_neighbours = 10;
/// More groups than this are neighbours by their place in the first row alone.
constexpr std::size_t most_measured = 3000;
constexpr double cold = 0.02;  ///< metres

/// The cheapest passage when those groups are finished whose place is not after `at`.
double cheapest(const std::vector<Passage>& passages, const std::vector<int>& place, int at) {
    double best = std::numeric_limits<double>::infinity();
    for (const Passage& passage : passages) {
        if (passage.length >= best) break;
        double sum = passage.length;
        for (const Passage::Spoils& spoils : passage.spoils)
            if (place[static_cast<std::size_t>(spoils.group)] <= at) sum += spoils.cost;
        best = std::min(best, sum);
    }
    return best;
}

}  // namespace

Annealer::Annealer(Row row, const Job& job, Pairs& pairs, std::uint64_t seed)
    : job_(job),
      pairs_(pairs),
      row_(std::move(row)),
      size_(static_cast<int>(row_.size())),
      place_(job.groups.size()),
      after_(job.groups.size()),
      batch_(job.groups.size(), 0),
      glued_(job.groups.size(), 0),
      area_(job.groups.size(), -1),
      tried_(job.groups.size(), -1),
      random_(seed) {
    for (int k = 0; k < size_; ++k) place_at(k) = k;
    for (std::size_t g = 0; g < job.groups.size(); ++g)
        if (job.groups[g].work.strokes.front().fill) area_[g] = job.groups[g].work.element;
    for (const auto& [a, b] : job.before) after_[static_cast<std::size_t>(a)].push_back(b);
    for (std::size_t i = 0; i < job.batches.size(); ++i)
        for (const int group : job.batches[i]) batch_[static_cast<std::size_t>(group)] = static_cast<int>(i);
    for (const Tie& tie : job.ties) {
        const int a = place_[static_cast<std::size_t>(tie.a)], b = place_[static_cast<std::size_t>(tie.b)];
        glued_[static_cast<std::size_t>(a < b ? tie.a : tie.b)] = 1;  // to the next one
    }
    find_neighbours();
    for (int k = 0; k <= size_ - 1; ++k) costs_.push_back(leg(k));
    for (const double c : costs_) sum_ += c;
}

Annealed Annealer::run(const Annealing& options, const Progress& progress) {
    const double hot = options.hot;
    Annealed best{row_};
    double least = sum_;
    double heat = hot;
    constexpr std::uint64_t between_looks = 64;
    for (std::uint64_t moves = 0; work_ < options.work; ++moves) {
        if (moves % between_looks == 0) {
            if (work_ >= options.least && progress.stopped()) {
                best.stopped = true;
                break;
            }
            heat = hot * std::pow(cold / hot, static_cast<double>(work_) / static_cast<double>(options.work));
        }
        // the Metropolis rule, turned round: what a move may cost is drawn first
        step(-heat * std::log(1 - uniform()));
        ++work_;
        if (sum_ < least - 1e-9) {
            least = sum_;
            best.row = row_;
        }
    }
    return best;
}

double Annealer::to_ends(int k) {
    double sum = 0;
    if (k == 0 && job_.parked)
        sum += pairs_.from_parked(row_[static_cast<std::size_t>(k)]);
    else if (k == 0 && job_.start)
        sum += distance(*job_.start, candidate_at(k).start.at);
    if (k == size_ - 1 && !job_.exits.empty())
        sum += pairs_.to_exit(row_[static_cast<std::size_t>(k)]);
    else if (k == size_ - 1 && job_.end)
        sum += distance(candidate_at(k).end.at, *job_.end);
    return sum;
}

double Annealer::leg(int k) {
    ++work_;
    const Candidate& here = candidate_at(k);
    if (k == 0) return here.longer + to_ends(k);
    const auto& passages =
        pairs_.passages(row_[static_cast<std::size_t>(k - 1)], row_[static_cast<std::size_t>(k)]);
    return here.longer + to_ends(k) + cheapest(passages, place_, k - 1);
}

double Annealer::least_leg(int k) {
    const Candidate& here = candidate_at(k);
    if (k == 0) return here.longer + to_ends(k);
    return here.longer + to_ends(k) +
           pairs_.shortest(row_[static_cast<std::size_t>(k - 1)], row_[static_cast<std::size_t>(k)]);
}

void Annealer::find_neighbours() {
    const auto n = static_cast<std::size_t>(size_);
    near_.resize(job_.groups.size());
    struct Near {
        double d;
        int group;
        bool operator<(const Near& o) const { return d != o.d ? d < o.d : group < o.group; }
    };
    std::vector<Near> all;
    for (std::size_t k = 0; k < n; ++k) {
        all.clear();
        const Candidate& a = candidate_at(static_cast<int>(k));
        const std::size_t low = n <= most_measured ? 0 : k - std::min(k, most_neighbours),
                          high = n <= most_measured ? n : std::min(n, k + most_neighbours);
        for (std::size_t j = low; j < high; ++j) {
            if (j == k) continue;
            const Candidate& b = candidate_at(static_cast<int>(j));
            double d = std::numeric_limits<double>::infinity();
            for (const Point p : {a.rake_start.at, a.rake_end.at})
                for (const Point q : {b.rake_start.at, b.rake_end.at}) d = std::min(d, distance(p, q));
            all.push_back({d, group_at(static_cast<int>(j))});
        }
        const std::size_t kept = std::min(all.size(), most_neighbours);
        std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end());
        auto& near = near_[static_cast<std::size_t>(group_at(static_cast<int>(k)))];
        for (std::size_t i = 0; i < kept; ++i) near.push_back(all[i].group);
    }
}

void Annealer::offer(int from, double allowed) {
    const int to = from + static_cast<int>(part_.size()), last = std::min(to, size_ - 1);
    double old = 0;
    for (int k = from; k <= last; ++k) old += costs_[static_cast<std::size_t>(k)];
    const auto swap_in = [&] {
        for (int k = from; k < to; ++k)
            std::swap(row_[static_cast<std::size_t>(k)], part_[static_cast<std::size_t>(k - from)]);
        for (int k = from; k < to; ++k) place_at(k) = k;
    };
    swap_in();
    double least = 0;
    for (int k = from; k <= last; ++k) least += least_leg(k);
    if (least > old + allowed) {
        ++work_;
        return swap_in();
    }
    next_.clear();
    double sum = 0;
    for (int k = from; k <= last; ++k) {
        next_.push_back(leg(k));
        sum += next_.back();
        if (sum > old + allowed) return swap_in();
    }
    for (int k = from; k <= last; ++k)
        costs_[static_cast<std::size_t>(k)] = next_[static_cast<std::size_t>(k - from)];
    sum_ += sum - old;
}

Annealed annealed(Row row, const Job& job, Pairs& pairs, const Annealing& options, const Progress& progress) {
    if (row.size() < 2) return {std::move(row)};
    return Annealer(std::move(row), job, pairs, options.seed).run(options, progress);
}

}  // namespace strandline::order
