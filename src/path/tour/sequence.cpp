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
      at_(model.ends),
      link_(at_.size(), 0) {
    tour_.reserve(at_.size());
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
    for (const Visit& visit : order)
        if (model.is_polygon(visit.piece)) choose(visit.piece, visit.choice);
    for (const int node : tour_) measure(node);
    if (!order.empty()) anchor_ = order.front().piece;
    forget();
}

double Sequence::length() const {
    double sum = 0;
    for (int place = 1; place < nodes(); place += 2) sum += gap(node_at(place), node_at(wrapped(place + 1)));
    return sum;
}

int Sequence::new_order(const int* t, int k, int circle, Run* runs) const {
    assert(k > 0);
    // Links by the place they begin at, in ring order.
    int begins[most_links], slot[2 * most_links], order[most_links];
    for (int i = 0; i < k; ++i) {
        const int a = place_of(t[2 * i]), b = place_of(t[2 * i + 1]);
        begins[i] = (a & 1) ? a : b;
        order[i] = i;
    }
    for (int i = 1; i < k; ++i)
        for (int j = i; j > 0 && begins[order[j]] < begins[order[j - 1]]; --j)
            std::swap(order[j], order[j - 1]);
    // Slot 2r is the left end of run r, 2r + 1 its right end; run r begins after the link order[r].
    for (int r = 0; r < k; ++r) {
        const int i = order[r];
        const bool first_is_right = (place_of(t[2 * i]) & 1) != 0;
        const int right_of_previous = 2 * ((r + k - 1) % k) + 1, left_of_this = 2 * r;
        slot[2 * i] = first_is_right ? right_of_previous : left_of_this;
        slot[2 * i + 1] = first_is_right ? left_of_this : right_of_previous;
    }
    int joined[2 * most_links];
    for (int i = 0; i < k; ++i) {
        const int begin = i < circle ? 0 : circle, end = i < circle ? std::min(circle, k) : k;
        const int a = slot[2 * i + 1], b = slot[2 * (i + 1 < end ? i + 1 : begin)];
        joined[a] = b;
        joined[b] = a;
    }
    int met = 0, here = 0;
    do {
        const int r = here / 2;
        const int begin = wrapped(begins[order[r]] + 1), end = begins[order[(r + 1) % k]];
        int length = end - begin + 1;
        if (length <= 0) length += nodes();
        runs[met++] = {begin, length, (here & 1) != 0};
        here = joined[here ^ 1];
    } while (here != 0 && met < k);
    return here == 0 ? met : 0;
}

bool Sequence::closes(const int* t, int k) const {
    Run runs[most_links];
    return new_order(t, k, k, runs) == k;
}

void Sequence::exchange(const int* t, int k, int circle) {
    Run runs[most_links];
    new_order(t, k, circle, runs);
    int longest = 0;
    for (int r = 1; r < k; ++r)
        if (runs[r].count > runs[longest].count) longest = r;
    // The longest run stays. Read so that it runs forward, the others follow it in their new order.
    laid_.clear();
    const bool turned = runs[longest].backward;
    for (int s = 1; s < k; ++s) {
        const Run& run = runs[(longest + (turned ? k - s : s)) % k];
        if (run.backward != turned)
            for (int i = 0, place = wrapped(run.begin + run.count - 1); i < run.count;
                 ++i, place = place == 0 ? nodes() - 1 : place - 1)
                laid_.push_back(node_at(place));
        else
            for (int i = 0, place = run.begin; i < run.count; ++i, place = wrapped(place + 1))
                laid_.push_back(node_at(place));
    }
    const int begin = wrapped(runs[longest].begin + runs[longest].count);
    log_.push_back({begin, static_cast<int>(laid_.size()), saved_.size(), 2 * k});
    int place = begin;
    for (const int node : laid_) {
        saved_.push_back(node_at(place));
        tour_[index(place)] = node;
        place_[index(node)] = place;
        place = wrapped(place + 1);
    }
    for (int i = 0; i < 2 * k; ++i) {
        saved_.push_back(t[i]);
        measure(t[i]);
    }
}

void Sequence::choose(int piece, int choice) {
    log_.push_back({piece, -1, index(choice_[index(piece)]), 0});
    choice_[index(piece)] = choice;
    at_[index(2 * piece)] = at_[index(2 * piece + 1)] =
        model_->choices[index(model_->pieces[index(piece)].first_choice + choice)].at;
    for (const int node : {2 * piece, 2 * piece + 1}) {
        measure(node);
        measure(mate(node));
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
        int place = entry.begin;
        for (int i = 0; i < entry.count; ++i, place = wrapped(place + 1)) {
            const int node = saved_[entry.saved + index(i)];
            tour_[index(place)] = node;
            place_[index(node)] = place;
        }
        for (int i = 0; i < entry.ends; ++i) measure(saved_[entry.saved + index(entry.count + i)]);
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
