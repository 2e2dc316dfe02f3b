#include "path/tour/near.hpp"

#include <algorithm>
#include <limits>

#include "path/tour/order.hpp"

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Points a leaf holds: few enough to scan, enough to keep the tree small.
constexpr int leaf_size = 6;
/// Vertices a polygon is asked from, and is known by, in the candidate lists: beyond these the lists do not
/// change enough to pay.
constexpr int asked_vertices = 32, known_vertices = 128;

double squared(Point a, Point b) { return dot(b - a, b - a); }
double squared(const Box& box, Point p) {
    const double dx = std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                 dy = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
    return dx * dx + dy * dy;
}

}  // namespace

Tree::Tree(std::vector<Entry> entries)
    : entries_(std::move(entries)), out_(entries_.size(), false), leaf_of_(entries_.size(), 0) {
    if (!entries_.empty()) build(0, size(), -1);
}

int Tree::build(int begin, int end, int parent) {
    const int c = static_cast<int>(cells_.size());
    Box box;
    for (int k = begin; k < end; ++k) box = including(box, entries_[at(k)].at);
    cells_.push_back({box, begin, end, -1, -1, parent, end - begin});
    if (end - begin <= leaf_size) {
        for (int k = begin; k < end; ++k) leaf_of_[at(k)] = c;
        return c;
    }
    const bool wide = box.width() >= box.height();
    const int middle = begin + (end - begin) / 2;
    // Full order on ties, so that the tree is the same on every library.
    std::nth_element(entries_.begin() + begin, entries_.begin() + middle, entries_.begin() + end,
                     [wide](const Entry& a, const Entry& b) {
                         const double u = wide ? a.at.x : a.at.y, v = wide ? b.at.x : b.at.y;
                         return u != v ? u < v : a.owner < b.owner;
                     });
    const int left = build(begin, middle, c), right = build(middle, end, c);
    cells_[at(c)].left = left;
    cells_[at(c)].right = right;
    return c;
}

int Tree::nearest(Point p) const {
    if (cells_.empty() || cells_[0].alive == 0) return -1;
    double best = std::numeric_limits<double>::infinity();
    int found = -1;
    int stack[128];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Cell& cell = cells_[at(stack[--depth])];
        if (cell.alive == 0 || squared(cell.box, p) >= best) continue;
        if (cell.left < 0) {
            for (int k = cell.begin; k < cell.end; ++k)
                if (const double d = squared(entries_[at(k)].at, p); !out_[at(k)] && d < best) {
                    best = d;
                    found = k;
                }
            continue;
        }
        const bool left_first =
            squared(cells_[at(cell.left)].box, p) <= squared(cells_[at(cell.right)].box, p);
        stack[depth++] = left_first ? cell.right : cell.left;
        stack[depth++] = left_first ? cell.left : cell.right;
    }
    return found;
}

void Tree::remove(int index) {
    if (out_[at(index)]) return;
    out_[at(index)] = true;
    for (int c = leaf_of_[at(index)]; c >= 0; c = cells_[at(c)].parent) --cells_[at(c)].alive;
}

void Tree::nearest_owners(Point p, int self, int count, std::vector<Found>& found) const {
    if (cells_.empty()) return;
    const auto keep = [&](double d, int owner) {
        const auto old =
            std::find_if(found.begin(), found.end(), [&](const Found& f) { return f.owner == owner; });
        if (old != found.end()) {
            if (old->squared <= d) return;
            found.erase(old);
        }
        const auto place = std::find_if(found.begin(), found.end(), [&](const Found& f) {
            return d < f.squared || (d == f.squared && owner < f.owner);
        });
        found.insert(place, {d, owner});
        if (static_cast<int>(found.size()) > count) found.pop_back();
    };
    const auto limit = [&] {
        return static_cast<int>(found.size()) < count ? std::numeric_limits<double>::infinity()
                                                      : found.back().squared;
    };
    int stack[128];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Cell& cell = cells_[at(stack[--depth])];
        if (squared(cell.box, p) >= limit()) continue;
        if (cell.left < 0) {
            for (int k = cell.begin; k < cell.end; ++k)
                if (const double d = squared(entries_[at(k)].at, p);
                    entries_[at(k)].owner != self && d < limit())
                    keep(d, entries_[at(k)].owner);
            continue;
        }
        const bool left_first =
            squared(cells_[at(cell.left)].box, p) <= squared(cells_[at(cell.right)].box, p);
        stack[depth++] = left_first ? cell.right : cell.left;
        stack[depth++] = left_first ? cell.left : cell.right;
    }
}

Candidates find_candidates(const Model& model, int count) {
    // Owners are nodes; a polygon owns its points by its first node. A line's two ends are two owners.
    std::vector<Tree::Entry> entries;
    const auto step = [](int choices, int most) { return std::max(1, (choices + most - 1) / most); };
    for (int p = 0; p < model.piece_count(); ++p) {
        const Piece& piece = model.pieces[at(p)];
        if (piece.choices > 0)
            for (int c = 0; c < piece.choices; c += step(piece.choices, known_vertices))
                entries.push_back({model.choices[at(piece.first_choice + c)].at, 2 * p});
        else
            for (const int node : {2 * p, 2 * p + 1}) entries.push_back({model.ends[at(node)], node});
    }
    for (int node = 2 * model.piece_count(); node < model.loose_from; ++node)
        entries.push_back({model.ends[at(node)], node});
    const Tree tree(std::move(entries));

    Candidates result;
    result.first.reserve(at(model.node_count() + 1));
    std::vector<Tree::Found> found;
    for (int node = 0; node < model.node_count(); ++node) {
        result.first.push_back(static_cast<int>(result.all.size()));
        const int p = node / 2;
        if (node >= model.loose_from) continue;  // everything is at distance 0: no list helps
        for (int loose = model.loose_from; loose < model.node_count(); ++loose)
            result.all.push_back({loose, true, 0});
        const bool polygon = model.is_polygon(p);
        if (!polygon || node % 2 == 0) found.clear();
        if (!polygon) {
            tree.nearest_owners(model.ends[at(node)], node, count + 1, found);
        } else if (node % 2 == 0) {
            const Piece& piece = model.pieces[at(p)];
            for (int c = 0; c < piece.choices; c += step(piece.choices, asked_vertices))
                tree.nearest_owners(model.choices[at(piece.first_choice + c)].at, node, count + 1, found);
        }
        int taken = 0;
        for (const Tree::Found& f : found) {
            if (f.owner / 2 == p) continue;  // the other end of the same line
            if (taken++ == count) break;
            const double gap = std::sqrt(f.squared);
            const bool exact = !polygon && !model.is_polygon(f.owner / 2);
            result.all.push_back({f.owner, exact, gap});
            if (model.is_polygon(f.owner / 2)) result.all.push_back({f.owner + 1, false, gap});
        }
    }
    result.first.push_back(static_cast<int>(result.all.size()));
    return result;
}

std::vector<Visit> nearest_order(const Model& model) {
    std::vector<Tree::Entry> entries;
    for (int p = 0; p < model.piece_count(); ++p) {
        const Piece& piece = model.pieces[at(p)];
        for (int c = 0; c < piece.choices; ++c)
            entries.push_back({model.choices[at(piece.first_choice + c)].at, (piece.first_choice + c)});
        if (piece.choices == 0)
            for (const int node : {2 * p, 2 * p + 1}) entries.push_back({model.ends[at(node)], -1 - node});
    }
    // Owners here: choices by their number, nodes of lines below zero; where each went in the tree is looked
    // up once.
    Tree tree(std::move(entries));
    std::vector<int> entry_of_choice(model.choices.size()), entry_of_node(at(2 * model.piece_count()));
    for (int k = 0; k < tree.size(); ++k) {
        const int owner = tree.entry(k).owner;
        (owner < 0 ? entry_of_node[at(-1 - owner)] : entry_of_choice[at(owner)]) = k;
    }
    std::vector<int> piece_of_choice(model.choices.size());
    for (int p = 0; p < model.piece_count(); ++p)
        for (int c = 0; c < model.pieces[at(p)].choices; ++c)
            piece_of_choice[at(model.pieces[at(p)].first_choice + c)] = p;

    std::vector<Visit> order;
    order.reserve(model.pieces.size());
    const auto take = [&](Visit visit) {
        const Piece& piece = model.pieces[at(visit.piece)];
        order.push_back(visit);
        for (int c = 0; c < piece.choices; ++c) tree.remove(entry_of_choice[at(piece.first_choice + c)]);
        if (piece.choices > 0) return model.choices[at(piece.first_choice + visit.choice)].at;
        for (const int node : {2 * visit.piece, 2 * visit.piece + 1}) tree.remove(entry_of_node[at(node)]);
        return model.ends[at(2 * visit.piece + (visit.backward ? 0 : 1))];
    };
    if (model.pieces.empty()) return order;
    Point here = model.problem->start ? *model.problem->start : take({model.piece_of.front(), false, 0});
    for (int k = tree.nearest(here); k >= 0; k = tree.nearest(here)) {
        const int owner = tree.entry(k).owner;
        if (owner < 0)
            here = take({(-1 - owner) / 2, (-1 - owner) % 2 == 1, 0});
        else {
            const int p = piece_of_choice[at(owner)];
            here = take({p, false, owner - model.pieces[at(p)].first_choice});
        }
    }
    return order;
}

}  // namespace strandline::tour
