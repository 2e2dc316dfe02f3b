// A first order by the shortest links.
#include <algorithm>

#include "path/tour/near.hpp"

namespace strandline::tour {
namespace {

/// Ends of other rows that an end is compared with, after the first round.
constexpr int compared = 6;
/// Vertices of a polygon that are compared.
constexpr int most_vertices = 16;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Pair {
    double gap;
    int a, b;
    bool operator<(const Pair& o) const { return gap != o.gap ? gap < o.gap : a != o.a ? a < o.a : b < o.b; }
};

/// Rows of pieces, at first one each, joined end to end. The start, where there is one, is a row of one node
/// that is joined once.
class Rows {
  public:
    explicit Rows(const Model& model)
        : model_(model), linked_(at(model.node_count()), -1), other_(at(model.node_count())) {
        for (int node = 0; node < model.node_count(); ++node) other_[at(node)] = node ^ 1;
        count_ = model.piece_count();
        if (const int start = this->start(); start >= 0) {
            other_[at(start)] = start;
            ++count_;
        }
    }

    int count() const { return count_; }
    /// Joins what is free on both sides and not one row already, shortest first.
    void join(std::vector<Pair> links) {
        std::sort(links.begin(), links.end());
        for (const auto& [gap, a, b] : links) {
            if (linked_[at(a)] >= 0 || linked_[at(b)] >= 0 || other_[at(a)] == b || count_ == 1) continue;
            const int front = other_[at(a)], back = other_[at(b)];
            linked_[at(a)] = b;
            linked_[at(b)] = a;
            other_[at(front)] = back;
            other_[at(back)] = front;
            --count_;
        }
    }
    /// Links between ends of different rows.
    std::vector<Pair> near_ends() const {
        std::vector<Tree::Entry> entries;
        for (int node = 0; node < model_.loose_from; ++node)
            if (is_end(node)) for_points(node, [&](Point p) { entries.push_back({p, node}); });
        const Tree tree(std::move(entries));
        std::vector<Pair> links;
        std::vector<Tree::Found> found;
        for (int node = 0; node < model_.loose_from; ++node) {
            if (!is_end(node)) continue;
            found.clear();
            // one more, for the other end of its own row
            for_points(node, [&](Point p) { tree.nearest_owners(p, node, compared + 1, found); });
            for (const Tree::Found& f : found)
                if (f.owner != other_[at(node)])
                    links.push_back({f.squared, std::min(node, f.owner), std::max(node, f.owner)});
        }
        return links;
    }
    std::vector<Visit> order() const {
        int node = start();
        if (node >= 0)
            node = linked_[at(node)];
        else
            for (node = 0; !is_end(node);) ++node;
        std::vector<Visit> order;
        for (; node >= 0; node = linked_[at(node ^ 1)]) order.push_back({node / 2, node % 2 == 1, 0});
        return order;
    }

  private:
    int start() const {
        return model_.gate && model_.gate_start < model_.loose_from ? model_.gate_start : -1;
    }
    bool is_end(int node) const {
        return linked_[at(node)] < 0 && (node < 2 * model_.piece_count() || node == start());
    }
    template <class Use>
    void for_points(int node, const Use& use) const {
        if (!model_.is_polygon(node / 2)) return use(model_.ends[at(node)]);
        const Piece& piece = model_.pieces[at(node / 2)];
        const int step = std::max(1, (piece.choices + most_vertices - 1) / most_vertices);
        for (int c = 0; c < piece.choices; c += step) use(model_.choices[at(piece.first_choice + c)].at);
    }

    const Model& model_;
    std::vector<int> linked_, other_;  ///< other_: of a row's end, the other one
    int count_;
};

}  // namespace

std::vector<Visit> greedy_order(const Model& model, const Candidates& near) {
    if (model.pieces.empty()) return {};
    Rows rows(model);
    std::vector<Pair> links;
    for (int node = 0; node < 2 * model.piece_count(); ++node)
        for (int k = near.first[at(node)]; k < near.first[at(node + 1)]; ++k)
            if (const auto& [other, exact, gap] = near.all[at(k)];
                node < other && (other < 2 * model.piece_count()))
                links.push_back({gap, node, other});
    rows.join(std::move(links));
    while (rows.count() > 1) rows.join(rows.near_ends());
    return rows.order();
}

}  // namespace strandline::tour
