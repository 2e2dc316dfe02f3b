#include "path/tour/gates.hpp"

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool Gates::lets(Mask passed, int last_way, int way) const {
    if (!any) return true;
    const Way& w = ways[at(way)];
    if ((w.must & ~passed) || (w.must_not & passed)) return false;
    const int left = last_way < 0 ? -1 : ways[at(last_way)].exit_group;
    // A group begun is finished first; one is entered in its midst only from itself.
    if (left >= 0 && left != w.entry_group && (groups[at(left)] & ~passed)) return false;
    if (w.entry_group >= 0 && left != w.entry_group && (groups[at(w.entry_group)] & passed)) return false;
    return true;
}

Gates build_gates(const Model& model) {
    const Rules& rules = model.rules;
    Gates gates;
    gates.any = rules.any;
    gates.ways.resize(2 * model.pieces.size());
    gates.groups.assign(rules.group_size.size(), 0);
    for (std::size_t e = 0; e < model.piece_of.size(); ++e)
        if (const int g = rules.group_of[e]; g >= 0) gates.groups[at(g)] |= bit(model.piece_of[e]);
    for (int p = 0; p < model.piece_count(); ++p) {
        const Piece& piece = model.pieces[at(p)];
        const int size = static_cast<int>(piece.members.size());
        for (int backward = 0; backward < 2; ++backward) {
            Gates::Way& way = gates.ways[at(2 * p + backward)];
            way.open = piece.direction == 0 || (piece.direction < 0) == (backward == 1);
            const auto group_at = [&](int k) {
                return rules.group_of[at(piece.members[at(backward ? size - 1 - k : k)].element)];
            };
            way.entry_group = group_at(0);
            way.exit_group = group_at(size - 1);
            for (int k = 0; k < size; ++k) {
                const int g = group_at(k);
                if (g < 0) continue;
                const Mask others = gates.groups[at(g)] & ~bit(p);
                if (k > 0 && group_at(k - 1) != g) way.must_not |= others;
                if (k + 1 < size && group_at(k + 1) != g) way.must |= others;
                if (rules.keep_group_order)
                    for (int h = 0; h < g; ++h) way.must |= gates.groups[at(h)] & ~bit(p);
            }
        }
    }
    for (const auto& [i, j] : rules.before)
        for (int backward = 0; backward < 2; ++backward)
            gates.ways[at(2 * model.piece_of[at(j)] + backward)].must |= bit(model.piece_of[at(i)]);
    return gates;
}

}  // namespace strandline::tour
