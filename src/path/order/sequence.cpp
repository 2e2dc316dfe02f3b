#include "path/order/sequence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strandline::order {
namespace {

/// Groups beside which a group is tried.
constexpr std::size_t most_neighbours = 10;
/// More groups than this are neighbours by their place in the first row alone.
constexpr std::size_t most_measured = 3000;
/// Longest part of the row that is moved or turned about, and over which it is moved.
constexpr int longest_part = 40;
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

class Annealer {
  public:
    Annealer(Row row, const Job& job, Pairs& pairs, std::uint64_t seed)
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
        for (const auto& [a, b] : job.before) {
            after_[static_cast<std::size_t>(a)].push_back(b);
        }
        for (std::size_t i = 0; i < job.batches.size(); ++i)
            for (const int group : job.batches[i])
                batch_[static_cast<std::size_t>(group)] = static_cast<int>(i);
        for (const Tie& tie : job.ties) {
            const int a = place_[static_cast<std::size_t>(tie.a)],
                      b = place_[static_cast<std::size_t>(tie.b)];
            glued_[static_cast<std::size_t>(a < b ? tie.a : tie.b)] = 1;  // to the next one
        }
        find_neighbours();
        for (int k = 0; k <= size_ - 1; ++k) costs_.push_back(leg(k));
        for (const double c : costs_) sum_ += c;
    }

    Annealed run(const Annealing& options, const Progress& progress) {
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
                heat = hot *
                       std::pow(cold / hot, static_cast<double>(work_) / static_cast<double>(options.work));
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

  private:
    double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
    int group_at(int k) const { return pairs_.group_of(row_[static_cast<std::size_t>(k)]); }
    int& place_at(int k) { return place_[static_cast<std::size_t>(group_at(k))]; }
    const Candidate& candidate_at(int k) const {
        return pairs_.all()[static_cast<std::size_t>(row_[static_cast<std::size_t>(k)])];
    }

    /// From where the drive is to begin, and to where it is to end.
    double to_ends(int k) const {
        double sum = 0;
        if (k == 0 && job_.start) sum += distance(*job_.start, candidate_at(k).start.at);
        if (k == size_ - 1 && job_.end) sum += distance(candidate_at(k).end.at, *job_.end);
        return sum;
    }
    /// What it costs to come to place k and to be there.
    double leg(int k) {
        ++work_;
        const Candidate& here = candidate_at(k);
        if (k == 0) return here.longer + to_ends(k);
        const auto& passages =
            pairs_.passages(row_[static_cast<std::size_t>(k - 1)], row_[static_cast<std::size_t>(k)]);
        return here.longer + to_ends(k) + cheapest(passages, place_, k - 1);
    }
    double least_leg(int k) {
        const Candidate& here = candidate_at(k);
        if (k == 0) return here.longer + to_ends(k);
        return here.longer + to_ends(k) +
               pairs_.shortest(row_[static_cast<std::size_t>(k - 1)], row_[static_cast<std::size_t>(k)]);
    }

    void find_neighbours() {
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

    void step(double allowed) {
        if (size_ < 2) return;
        const int k = below(size_);
        switch (below(4)) {
            case 0:
                return go_otherwise(k, allowed);
            case 1:
                return turn_about(k, allowed);
            default:
                return move(k, allowed);
        }
    }

    /// Another way through one group.
    void go_otherwise(int k, double allowed) {
        const auto [first, end] = pairs_.of_group(group_at(k));
        if (end - first < 2) return;
        part_.assign(1, first + below(end - first));
        offer(k, allowed);
    }

    int mate(int candidate) const {
        // the same node in the other sense, or the other direction
        const auto [first, end] = pairs_.of_group(pairs_.group_of(candidate));
        const Going& going = pairs_.all()[static_cast<std::size_t>(candidate)].going;
        const bool closed = end - first > 2;
        for (int c = first; c < end; ++c) {
            const Going& other = pairs_.all()[static_cast<std::size_t>(c)].going;
            if (other.step.reversed != going.step.reversed &&
                (!closed || other.step.entry == going.step.entry))
                return c;
        }
        return candidate;
    }
    bool glued_after(int k) const {
        return k >= 0 && k < size_ && glued_[static_cast<std::size_t>(group_at(k))] != 0;
    }
    bool one_batch(int from, int to) const {
        return batch_[static_cast<std::size_t>(group_at(from))] ==
               batch_[static_cast<std::size_t>(group_at(to))];
    }

    void take(int first, int end) {
        for (int i = first; i < end; ++i) part_.push_back(row_[static_cast<std::size_t>(i)]);
    }
    int area_at(int k) const { return area_[static_cast<std::size_t>(group_at(k))]; }
    /// The other way round; strokes of one area that follow one another stay as they are.
    void take_turned(int first, int end) {
        for (int i = end; i > first;) {
            int j = i - 1;
            while (j > first && area_at(j) >= 0 && area_at(j - 1) == area_at(j)) --j;
            if (j + 1 == i)
                part_.push_back(mate(row_[static_cast<std::size_t>(j)]));
            else
                take(j, i);
            i = j;
        }
    }
    /// Whether what must come before still does, with `part_` at `from`.
    bool keeps_order(int from) {
        const int to = from + static_cast<int>(part_.size());
        int at = from;
        for (const int candidate : part_) tried_[static_cast<std::size_t>(pairs_.group_of(candidate))] = at++;
        return std::ranges::all_of(part_, [&](int candidate) {
            const auto group = static_cast<std::size_t>(pairs_.group_of(candidate));
            return std::ranges::all_of(after_[group], [&](int later) {
                const int old = place_[static_cast<std::size_t>(later)];
                return old < from || old >= to || tried_[static_cast<std::size_t>(later)] > tried_[group];
            });
        });
    }

    /// From k to the place of a neighbour (either before or after it) the other way round.
    void turn_about(int k, double allowed) {
        const auto& near = near_[static_cast<std::size_t>(group_at(k))];
        const int other = place_[static_cast<std::size_t>(
            near[static_cast<std::size_t>(below(static_cast<int>(near.size())))])];
        int from = std::min(k, other), to = std::max(k, other);
        if (below(2) != 0)
            ++from;
        else
            --to;
        if (from >= to || to - from > longest_part || !one_batch(from, to)) return;
        for (int i = from - 1; i <= to; ++i)
            if (glued_after(i)) return;
        part_.clear();
        take_turned(from, to + 1);
        if (keeps_order(from)) offer(from, allowed);
    }

    /// A part that begins at k goes beside a neighbour, as it is or turned about.
    void move(int k, double allowed) {
        const int count = below(2) != 0 ? 1 : 1 + below(std::min(12, size_));
        const int end = k + count;  // before this
        if (end > size_) return;
        const bool head = below(2) != 0;
        const int group = group_at(head ? k : end - 1);
        const auto& near = near_[static_cast<std::size_t>(group)];
        const int other = place_[static_cast<std::size_t>(
            near[static_cast<std::size_t>(below(static_cast<int>(near.size())))])];
        if (other >= k && other < end) return;
        const bool turned = below(2) != 0;
        // the end that is near the neighbour comes next to it
        const bool behind = head != turned;
        const int gap = behind ? other + 1 : other;  // the part goes before what is at `gap`
        if (gap >= k && gap <= end && !turned) return;
        const int from = std::min(gap, k), to = std::max(gap, end);  // what changes: from to before to
        if (to - from > longest_part * 4 || !one_batch(from, to - 1)) return;
        if (glued_after(k - 1) || glued_after(end - 1) || glued_after(gap - 1)) return;
        if (turned)
            for (int i = k; i < end; ++i)
                if (glued_after(i)) return;
        part_.clear();
        const auto take_part = [&] { turned ? take_turned(k, end) : take(k, end); };
        if (gap <= k) {
            take_part();
            take(from, k);
        } else {
            take(end, to);
            take_part();
        }
        if (gap > k && gap < end) return;
        if (keeps_order(from)) offer(from, allowed);
    }

    /// `part_` in place of what is at `from` and after; taken where it costs no more than allowed.
    void offer(int from, double allowed) {
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

    const Job& job_;
    Pairs& pairs_;
    Row row_;
    int size_;
    std::vector<int> place_;  ///< by group
    std::vector<std::vector<int>> after_, near_;
    std::vector<int> batch_;
    std::vector<char> glued_;
    std::vector<int> area_;   ///< by group: the element whose fill it is a stroke of; -1: none
    std::vector<int> tried_;  ///< by group: its place in what is tried
    std::mt19937_64 random_;
    std::vector<double> costs_, next_;
    Row part_;
    double sum_ = 0;
    std::uint64_t work_ = 0;
};

}  // namespace

double cost_of(const Row& row, const Job& job, Pairs& pairs) {
    std::vector<int> place(job.groups.size());
    for (std::size_t k = 0; k < row.size(); ++k)
        place[static_cast<std::size_t>(pairs.group_of(row[k]))] = static_cast<int>(k);
    double sum = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
        const Candidate& here = pairs.all()[static_cast<std::size_t>(row[k])];
        sum += here.longer;
        if (k > 0)
            sum += cheapest(pairs.passages(row[k - 1], row[k]), place, static_cast<int>(k) - 1);
        else if (job.start)
            sum += distance(*job.start, here.start.at);
    }
    if (job.end && !row.empty())
        sum += distance(pairs.all()[static_cast<std::size_t>(row.back())].end.at, *job.end);
    return sum;
}

Annealed annealed(Row row, const Job& job, Pairs& pairs, const Annealing& options, const Progress& progress) {
    if (row.size() < 2) return {std::move(row)};
    return Annealer(std::move(row), job, pairs, options.seed).run(options, progress);
}

}  // namespace strandline::order
