// Orders without a search.
#include <algorithm>
#include <limits>

#include "path/tour/blocks.hpp"
#include "path/tour/order.hpp"

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Nearest neighbour over what is ready, or its first in the file.
class Walk {
  public:
    Walk(const Model& model, const Blocks& all, bool as_in_file)
        : model_(model),
          all_(all),
          as_in_file_(as_in_file),
          pending_(model.pieces.size(), 0),
          after_(model.pieces.size()) {
        for (const auto& [i, j] : model.rules.before) {
            const int p = model.piece_of[at(i)], q = model.piece_of[at(j)];
            if (all.block_of[at(p)] != all.block_of[at(q)]) continue;
            after_[at(p)].push_back(q);
            ++pending_[at(q)];
        }
        if (model.problem->start && !as_in_file)
            here_ = *model.problem->start;
        else
            anywhere_ = true;
    }

    std::vector<Visit> run() {
        std::vector<int> waiting(all_.blocks.size(), 0);
        std::vector<std::vector<int>> next(all_.blocks.size());
        for (const auto& [b, c] : all_.edges) {
            next[at(b)].push_back(c);
            ++waiting[at(c)];
        }
        std::vector<int> ready;
        for (std::size_t b = 0; b < waiting.size(); ++b)
            if (waiting[b] == 0) ready.push_back(static_cast<int>(b));
        while (!ready.empty()) {
            std::size_t best = 0;
            bool turned = false;
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < ready.size(); ++k)
                for (const bool way : {false, true}) {
                    const Block& block = all_.blocks[at(ready[k])];
                    if (!block.runs[way]) continue;
                    if (const double d = distance_to_block(block, way); d < nearest) {
                        nearest = d;
                        best = k;
                        turned = way;
                    }
                }
            const int b = ready[best];
            ready.erase(ready.begin() + static_cast<std::ptrdiff_t>(best));
            run_block(all_.blocks[at(b)], turned);
            for (const int c : next[at(b)])
                if (--waiting[at(c)] == 0) ready.push_back(c);
        }
        return std::move(order_);
    }

  private:
    /// The best way into a piece, forced to one way when `fixed` is +1 or -1.
    double way_in(int p, int fixed, Visit& visit) const {
        const Piece& piece = model_.pieces[at(p)];
        visit = {p, fixed < 0, 0};
        if (anywhere_) {
            if (fixed == 0) visit.backward = piece.direction < 0;
            return static_cast<double>(p);
        }
        double best = std::numeric_limits<double>::infinity();
        if (piece.choices > 0) {
            for (int c = 0; c < piece.choices; ++c)
                if (const double d = distance(here_, model_.choices[at(piece.first_choice + c)].at);
                    d < best) {
                    best = d;
                    visit.choice = c;
                }
            return best;
        }
        for (const bool backward : {false, true}) {
            const int wanted = fixed != 0 ? fixed : piece.direction;
            if (wanted != 0 && backward != (wanted < 0)) continue;
            if (const double d = distance(here_, model_.ends[at(2 * p + (backward ? 1 : 0))]); d < best) {
                best = d;
                visit.backward = backward;
            }
        }
        return best;
    }

    int fixed_way(const Block& block, const Item& item, bool turned) const {
        return block.items.size() == 1 ? 0 : item.backward != turned ? -1 : 1;
    }

    double distance_to_block(const Block& block, bool turned) const {
        const Item& item = turned ? block.items.back() : block.items.front();
        Visit visit;
        if (item.piece >= 0) return way_in(item.piece, fixed_way(block, item, turned), visit);
        double nearest = std::numeric_limits<double>::infinity();
        for (const int p : all_.inside[at(item.group)])
            if (pending_[at(p)] == 0) nearest = std::min(nearest, way_in(p, 0, visit));
        return nearest == std::numeric_limits<double>::infinity() ? 0 : nearest;
    }

    void take(const Visit& visit) {
        const Piece& piece = model_.pieces[at(visit.piece)];
        here_ = piece.choices > 0 ? model_.choices[at(piece.first_choice + visit.choice)].at
                                  : model_.ends[at(2 * visit.piece + (visit.backward ? 0 : 1))];
        anywhere_ = as_in_file_;
        order_.push_back(visit);
        for (const int q : after_[at(visit.piece)]) --pending_[at(q)];
    }

    void run_block(const Block& block, bool turned) {
        for (std::size_t k = 0; k < block.items.size(); ++k) {
            const Item& item = block.items[turned ? block.items.size() - 1 - k : k];
            Visit visit;
            if (item.piece >= 0) {
                way_in(item.piece, fixed_way(block, item, turned), visit);
                take(visit);
                continue;
            }
            std::vector<int> left = all_.inside[at(item.group)];
            while (!left.empty()) {
                std::size_t best = left.size();
                double nearest = std::numeric_limits<double>::infinity();
                for (std::size_t l = 0; l < left.size(); ++l) {
                    if (pending_[at(left[l])] > 0) continue;
                    if (const double d = way_in(left[l], 0, visit); d < nearest) {
                        nearest = d;
                        best = l;
                    }
                }
                way_in(left[best], 0, visit);
                take(visit);
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
            }
        }
    }

    const Model& model_;
    const Blocks& all_;
    bool as_in_file_;
    std::vector<int> pending_;
    std::vector<std::vector<int>> after_;
    std::vector<Visit> order_;
    Point here_;
    bool anywhere_ = false;  ///< every piece is as near as the next: in the order of the file
};

Outcome<std::vector<Visit>> walked(const Model& model, bool as_in_file) {
    auto blocks = build_blocks(model);
    if (!blocks) return tl::unexpected(blocks.error());
    if (const auto sound = check_blocks(model, *blocks); !sound) return tl::unexpected(sound.error());
    return Walk(model, *blocks, as_in_file).run();
}

}  // namespace

Outcome<std::vector<Visit>> first_order(const Model& model) {
    return model.rules.any ? walked(model, false) : nearest_order(model);
}

Outcome<std::vector<Visit>> file_order(const Model& model) {
    if (model.rules.any) return walked(model, true);
    std::vector<Visit> order;
    std::vector<bool> taken(model.pieces.size(), false);
    for (const int p : model.piece_of) {
        if (!taken[at(p)]) order.push_back({p, false, 0});
        taken[at(p)] = true;
    }
    return order;
}

}  // namespace strandline::tour
