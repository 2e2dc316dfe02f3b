#include "path/tour/sequence.hpp"

#include <algorithm>
#include <cassert>

namespace strandline::tour {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Sequence::Sequence(const Model& model, const std::vector<Visit>& order)
    : model_(&model),
      loose_from_(model.loose_from),
      place_(index(model.node_count())),
      choice_(index(model.piece_count()), 0),
      state_(model.ends.size()) {
    for (std::size_t node = 0; node < state_.size(); ++node) state_[node].at = model.ends[node];
    tour_.reserve(state_.size());
    if (model.gate) {
        tour_.push_back(model.gate_end);
        tour_.push_back(model.gate_start);
    }
    for (const Visit& visit : order) {
        const int first = 2 * visit.piece + (visit.backward ? 1 : 0);
        tour_.push_back(first);
        tour_.push_back(first ^ 1);
    }
    for (std::size_t k = 0; k < tour_.size(); ++k) place_[index(tour_[k])] = static_cast<int>(k);
    for (const int node : tour_) measure(node);
    for (const Visit& visit : order)
        if (model.is_polygon(visit.piece)) choose(visit.piece, visit.choice);
    if (!order.empty()) anchor_ = order.front().piece;
    forget();
}

double Sequence::length() const {
    double sum = 0;
    for (int place = 1; place < nodes(); place += 2) sum += gap(node_at(place), node_at(wrapped(place + 1)));
    return sum;
}

void Sequence::measure(int node) {
    const int place = place_of(node), last = nodes() - 1;
    State& own = state_[index(node)];
    own.mate = (place & 1) ? node_at(place == last ? 0 : place + 1) : node_at(place == 0 ? last : place - 1);
    own.link = gap(node, own.mate);
}

void Sequence::find_joints(const Change& change) const {
    const int k = static_cast<int>(change.t.size()) / 2;
    assert(k > 0);
    auto& [begins, order, slot, joined] = joints_;
    begins.resize(index(k));
    order.resize(index(k));
    slot.resize(index(2 * k));
    joined.resize(index(2 * k));
    // Links by the place they begin at, in ring order.
    for (int i = 0; i < k; ++i) {
        const int a = place_of(change.t[index(2 * i)]), b = place_of(change.t[index(2 * i + 1)]);
        begins[index(i)] = (a & 1) ? a : b;
        order[index(i)] = i;
    }
    constexpr int few = 16;
    if (k > few)
        std::sort(order.begin(), order.end(),
                  [&](int i, int j) { return begins[index(i)] < begins[index(j)]; });
    else
        for (int i = 1; i < k; ++i)
            for (int j = i; j > 0 && begins[index(order[index(j)])] < begins[index(order[index(j - 1)])]; --j)
                std::swap(order[index(j)], order[index(j - 1)]);
    // Slot 2r is the left end of run r, 2r + 1 its right end; run r begins after the link order[r].
    for (int r = 0; r < k; ++r) {
        const int i = order[index(r)];
        const bool first_is_right = (place_of(change.t[index(2 * i)]) & 1) != 0;
        const int right_of_previous = 2 * (r == 0 ? k - 1 : r - 1) + 1, left_of_this = 2 * r;
        slot[index(2 * i)] = first_is_right ? right_of_previous : left_of_this;
        slot[index(2 * i + 1)] = first_is_right ? left_of_this : right_of_previous;
    }
    int begin = 0;
    for (const int end : change.circles) {
        for (int i = begin; i < end; ++i) {
            const int a = slot[index(2 * i + 1)], b = slot[index(2 * (i + 1 < end ? i + 1 : begin))];
            joined[index(a)] = b;
            joined[index(b)] = a;
        }
        begin = end;
    }
}

Run Sequence::run_between(int r, int k, bool backward) const {
    const auto& [begins, order, slot, joined] = joints_;
    const int begin = wrapped(begins[index(order[index(r)])] + 1);
    int count = begins[index(order[index(r + 1 < k ? r + 1 : 0)])] - begin + 1;
    if (count <= 0) count += nodes();
    return {begin, count, backward, 0};
}

int Sequence::follow(int k) const {
    runs_.clear();
    int here = 0;
    do {
        runs_.push_back(run_between(here / 2, k, (here & 1) != 0));
        here = joints_.joined[index(here ^ 1)];
    } while (here != 0 && static_cast<int>(runs_.size()) < k);
    return here == 0 ? static_cast<int>(runs_.size()) : 0;
}

bool Sequence::closes(const int* t, int k) const {
    // The second node of a link that goes and the next one's first are joined: with two links the ring stays
    // whole if and only if both lie on the same side of their link.
    if (k == 2) return ((place_of(t[1]) ^ place_of(t[2])) & 1) == 0;
    int begins[most_links], order[most_links], slot[2 * most_links], joined[2 * most_links];
    for (int i = 0; i < k; ++i) {
        const int a = place_of(t[2 * i]), begin = (a & 1) ? a : place_of(t[2 * i + 1]);
        int j = i;
        for (; j > 0 && begin < begins[j - 1]; --j) {
            begins[j] = begins[j - 1];
            order[j] = order[j - 1];
        }
        begins[j] = begin;
        // Bit 0: whether the link's first node is the right end of the run before it.
        order[j] = 2 * i + (a & 1);
    }
    // Slot 2r is the left end of run r, 2r + 1 its right end; run r begins after the r-th link.
    for (int r = 0; r < k; ++r) {
        const int i = order[r] / 2, right_of_previous = 2 * (r == 0 ? k - 1 : r - 1) + 1;
        const bool first_is_right = (order[r] & 1) != 0;
        slot[2 * i] = first_is_right ? right_of_previous : 2 * r;
        slot[2 * i + 1] = first_is_right ? 2 * r : right_of_previous;
    }
    for (int i = 0; i < k; ++i) {
        const int a = slot[2 * i + 1], b = slot[i + 1 < k ? 2 * (i + 1) : 0];
        joined[a] = b;
        joined[b] = a;
    }
    int met = 0, here = 0;
    do {
        ++met;
        here = joined[here ^ 1];
    } while (here != 0 && met < k);
    return here == 0 && met == k;
}

int Sequence::rings(const Change& change, std::vector<Run>& runs) const {
    const int k = static_cast<int>(change.t.size()) / 2;
    find_joints(change);
    runs.clear();
    for (int r = 0; r < k; ++r) runs.push_back(run_between(r, k, false));
    std::vector<bool> met(index(k), false);
    int count = 0;
    for (int r = 0; r < k; ++r) {
        if (met[index(r)]) continue;
        int here = 2 * r;
        do {
            met[index(here / 2)] = true;
            runs[index(here / 2)].ring = count;
            here = joints_.joined[index(here ^ 1)];
        } while (!met[index(here / 2)]);
        ++count;
    }
    return count;
}

void Sequence::lay(int begin, const int* nodes_to_lay, int count) {
    const int first = std::min(count, nodes() - begin);
    std::copy(nodes_to_lay, nodes_to_lay + first, tour_.begin() + begin);
    std::copy(nodes_to_lay + first, nodes_to_lay + count, tour_.begin());
    for (int i = 0; i < first; ++i) place_[index(nodes_to_lay[i])] = begin + i;
    for (int i = first; i < count; ++i) place_[index(nodes_to_lay[i])] = i - first;
}

void Sequence::exchange(const Change& change) {
    const int k = static_cast<int>(change.t.size()) / 2;
    find_joints(change);
    [[maybe_unused]] const int met = follow(k);
    assert(met == k);
    int longest = 0;
    for (int r = 1; r < k; ++r)
        if (runs_[index(r)].count > runs_[index(longest)].count) longest = r;
    // The longest run stays. Read so that it runs forward, the others follow it in their new order.
    const Run& stays = runs_[index(longest)];
    const int count = nodes() - stays.count;
    laid_.resize(index(count));
    int* out = laid_.data();
    for (int s = 1; s < k; ++s) {
        const Run& run = runs_[index((longest + (stays.backward ? k - s : s)) % k)];
        const int before_wrap = std::min(run.count, nodes() - run.begin);
        const auto first = tour_.begin() + run.begin, middle = first + before_wrap;
        const auto rest = tour_.begin() + (run.count - before_wrap);
        if (run.backward != stays.backward) {
            out = std::reverse_copy(tour_.begin(), rest, out);
            out = std::reverse_copy(first, middle, out);
        } else {
            out = std::copy(first, middle, out);
            out = std::copy(tour_.begin(), rest, out);
        }
    }
    const int begin = wrapped(stays.begin + stays.count);
    const int ends = static_cast<int>(change.t.size());
    log_.push_back({begin, count, saved_.size(), ends});
    const int first = std::min(count, nodes() - begin);
    saved_.insert(saved_.end(), tour_.begin() + begin, tour_.begin() + begin + first);
    saved_.insert(saved_.end(), tour_.begin(), tour_.begin() + (count - first));
    saved_.insert(saved_.end(), change.t.begin(), change.t.end());
    lay(begin, laid_.data(), count);
    for (const int node : change.t) measure(node);
}

void Sequence::choose(int piece, int choice) {
    log_.push_back({piece, -1, index(choice_[index(piece)]), 0});
    choice_[index(piece)] = choice;
    const Point at = model_->choices[index(model_->pieces[index(piece)].first_choice + choice)].at;
    for (const int node : {2 * piece, 2 * piece + 1}) state_[index(node)].at = at;
    for (const int node : {2 * piece, 2 * piece + 1}) {
        State& own = state_[index(node)];
        own.link = state_[index(own.mate)].link = gap(node, own.mate);
    }
}

void Sequence::back(std::size_t mark) {
    while (log_.size() > mark) {
        const Entry entry = log_.back();
        log_.pop_back();
        if (entry.count < 0) {
            choose(entry.begin, static_cast<int>(entry.saved));
            log_.pop_back();
            continue;
        }
        const int* saved = saved_.data() + entry.saved;
        lay(entry.begin, saved, entry.count);
        for (int i = 0; i < entry.ends; ++i) measure(saved[entry.count + i]);
        saved_.resize(entry.saved);
    }
}

void Sequence::forget() {
    log_.clear();
    saved_.clear();
}

std::vector<Visit> Sequence::read(int from, int step) const {
    std::vector<Visit> order;
    order.reserve(index(model_->piece_count()));
    visits_read += static_cast<std::uint64_t>(model_->piece_count());
    for (int k = 0, place = from; k < model_->piece_count(); ++k) {
        const int node = node_at(place), piece = node / 2;
        order.push_back({piece, node % 2 == 1 && !model_->is_polygon(piece), choice(piece)});
        place = (place + 2 * step + nodes()) % nodes();
    }
    return order;
}

std::vector<Visit> Sequence::order() const {
    if (model_->piece_count() == 0) return {};
    if (model_->gate) {
        const int place = place_of(model_->gate_start);
        return (place & 1) ? read(wrapped(place + 1), 1) : read(place == 0 ? nodes() - 1 : place - 1, -1);
    }
    // Either way round from the anchor; the one that keeps the rules, forward if both do.
    const int place = std::min(place_of(2 * anchor_), place_of(2 * anchor_ + 1));
    auto forward = read(place, 1);
    if (strandline::tour::keeps_rules(*model_, forward)) return forward;
    return read(place + 1, -1);
}

bool Sequence::keeps_rules() const {
    return !model_->rules.any || strandline::tour::keeps_rules(*model_, order());
}

}  // namespace strandline::tour
