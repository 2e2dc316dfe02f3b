// How the row is changed.
#include <algorithm>

#include "path/order/annealer.hpp"

namespace strandline::order {
namespace {

/// Longest part of the row that is moved or turned about, and over which it is moved.
constexpr int longest_part = 40;

}  // namespace

void Annealer::step(double allowed) {
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

void Annealer::go_otherwise(int k, double allowed) {
    const auto [first, end] = pairs_.of_group(group_at(k));
    if (end - first < 2) return;
    part_.assign(1, first + below(end - first));
    offer(k, allowed);
}

int Annealer::mate(int candidate) const {
    // the same node in the other sense, or the other direction
    const auto [first, end] = pairs_.of_group(pairs_.group_of(candidate));
    const Going& going = pairs_.all()[static_cast<std::size_t>(candidate)].going;
    const bool closed = end - first > 2;
    for (int c = first; c < end; ++c) {
        const Going& other = pairs_.all()[static_cast<std::size_t>(c)].going;
        if (other.step.reversed != going.step.reversed && (!closed || other.step.entry == going.step.entry))
            return c;
    }
    return candidate;
}

void Annealer::take(int first, int end) {
    for (int i = first; i < end; ++i) part_.push_back(row_[static_cast<std::size_t>(i)]);
}

void Annealer::take_turned(int first, int end) {
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

bool Annealer::keeps_order(int from) {
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

void Annealer::turn_about(int k, double allowed) {
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

void Annealer::move(int k, double allowed) {
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

}  // namespace strandline::order
