#include "path/tour/parts.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Point middle(const Model& model, int piece) {
    return 0.5 * (model.ends[at(2 * piece)] + model.ends[at(2 * piece + 1)]);
}

/// Cuts a row into `count` shares of equal size; shift > 0: count + 1, the first and the last smaller.
template <class Use>
void cut(std::size_t size, std::size_t count, double shift, const Use& use) {
    const double share = static_cast<double>(size) / static_cast<double>(count);
    std::size_t begin = 0;
    for (std::size_t k = 0; begin < size; ++k) {
        const double end = share * (static_cast<double>(k + 1) - (shift > 0 ? 1 - shift : 0));
        const auto last = std::clamp(static_cast<std::size_t>(std::llround(end)), begin, size);
        if (last > begin) use(begin, last);
        begin = last;
        if (k > count) break;
    }
}

}  // namespace

std::vector<std::vector<int>> parts_of(const Model& model, int most, double shift) {
    std::vector<int> pieces(at(model.piece_count()));
    for (int p = 0; p < model.piece_count(); ++p) pieces[at(p)] = p;
    const auto before = [&](bool along_x) {
        return [&model, along_x](int a, int b) {
            const Point p = middle(model, a), q = middle(model, b);
            const double u = along_x ? p.x : p.y, v = along_x ? q.x : q.y;
            return u != v ? u < v : a < b;
        };
    };
    const auto parts_wanted = at((model.piece_count() + most - 1) / most);
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(parts_wanted))));
    const std::size_t rows = (parts_wanted + columns - 1) / columns;
    std::vector<std::vector<int>> parts;
    std::sort(pieces.begin(), pieces.end(), before(true));
    cut(pieces.size(), columns, shift, [&](std::size_t left, std::size_t right) {
        const auto column = pieces.begin();
        std::sort(column + static_cast<std::ptrdiff_t>(left), column + static_cast<std::ptrdiff_t>(right),
                  before(false));
        cut(right - left, rows, shift, [&](std::size_t low, std::size_t high) {
            parts.emplace_back(column + static_cast<std::ptrdiff_t>(left + low),
                               column + static_cast<std::ptrdiff_t>(left + high));
        });
    });
    return parts;
}

Part part_of(const Model& model, const Candidates& near, const std::vector<Visit>& order,
             const std::vector<int>& pieces) {
    std::vector<bool> inside(at(model.piece_count()), false);
    for (const int piece : pieces) inside[at(piece)] = true;
    Part part;
    Model& own = part.model;
    own.problem = model.problem;
    own.tolerance = model.tolerance;
    std::vector<int> node_here(at(model.node_count()), -1), node_there;
    const auto add = [&](int first, int second, Piece piece, int choice, int of,
                         std::pair<int, int> stretch) {
        const int here = own.piece_count();
        node_here[at(first)] = 2 * here;
        node_here[at(second)] = 2 * here + 1;
        node_there.insert(node_there.end(), {first, second});
        own.pieces.push_back(std::move(piece));
        part.own.push_back(of);
        part.stretches.push_back(stretch);
        part.order.push_back({here, false, choice});
    };
    const int count = static_cast<int>(order.size());
    for (int k = 0; k < count; ++k) {
        const Visit& visit = order[at(k)];
        const int first = 2 * visit.piece + (visit.backward ? 1 : 0);
        if (inside[at(visit.piece)]) {
            const Piece& whole = model.pieces[at(visit.piece)];
            const int first_choice = static_cast<int>(own.choices.size());
            own.choices.insert(own.choices.end(), model.choices.begin() + whole.first_choice,
                               model.choices.begin() + whole.first_choice + whole.choices);
            add(2 * visit.piece, 2 * visit.piece + 1, {{}, first_choice, whole.choices, 0}, visit.choice,
                visit.piece, {k, k});
            part.order.back().backward = visit.backward;
            own.ends.insert(own.ends.end(),
                            {model.ends[at(2 * visit.piece)], model.ends[at(2 * visit.piece + 1)]});
            continue;
        }
        int last = k;
        while (last + 1 < count && !inside[at(order[at(last + 1)].piece)]) ++last;
        const Visit& end = order[at(last)];
        const int second = 2 * end.piece + (end.backward ? 0 : 1);
        const auto place = [&](const Visit& v, int node) {
            return model.is_polygon(v.piece)
                       ? model.choices[at(model.pieces[at(v.piece)].first_choice + v.choice)].at
                       : model.ends[at(node)];
        };
        own.ends.insert(own.ends.end(), {place(visit, first), place(end, second)});
        add(first, second, {}, 0, -1, {k, last});
        k = last;
    }
    own.gate = model.gate;
    own.loose_from = own.node_count();
    if (model.gate) {
        // The gate's nodes come last, loose ones behind the others, as in the whole.
        const int shift = own.node_count() - 2 * model.piece_count();
        own.gate_start = model.gate_start + shift;
        own.gate_end = model.gate_end + shift;
        own.loose_from = model.loose_from + shift;
        for (int node = 2 * model.piece_count(); node < model.node_count(); ++node) {
            node_here[at(node)] = node + shift;
            node_there.push_back(node);
            own.ends.push_back(model.ends[at(node)]);
        }
    }
    for (const int there : node_there) {
        part.near.first.push_back(static_cast<int>(part.near.all.size()));
        for (int c = near.first[at(there)]; c < near.first[at(there + 1)]; ++c) {
            const Candidates::Near& other = near.all[at(c)];
            const int here = node_here[at(other.node)];
            if (here < 0 || here / 2 == node_here[at(there)] / 2) continue;
            part.near.all.push_back({here, other.exact, other.gap});
        }
    }
    part.near.first.push_back(static_cast<int>(part.near.all.size()));
    return part;
}

std::vector<Visit> put_back(const Model& model, const Part& part, const std::vector<Visit>& found,
                            const std::vector<Visit>& order) {
    std::vector<Visit> whole;
    whole.reserve(order.size());
    for (const Visit& visit : found) {
        if (const int own = part.own[at(visit.piece)]; own >= 0) {
            whole.push_back({own, visit.backward, visit.choice});
            continue;
        }
        const auto [first, last] = part.stretches[at(visit.piece)];
        for (int k = 0; k <= last - first; ++k) {
            Visit v = order[at(visit.backward ? last - k : first + k)];
            if (visit.backward && !model.is_polygon(v.piece)) v.backward = !v.backward;
            whole.push_back(v);
        }
    }
    return whole;
}

}  // namespace strandline::tour
