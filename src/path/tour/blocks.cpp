// Whether an order can keep all rules: see order.hpp for the words block, item, inside.
#include "path/tour/blocks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "path/tour/order.hpp"

namespace strandline::tour {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Where a chain leads out of groups: the group at its front and at its back, -1 for none.
struct Border {
    int front = -1, back = -1;
};

Outcome<std::vector<Border>> find_borders(const Model& model, std::vector<std::vector<int>>& inside) {
    const Rules& rules = model.rules;
    const Problem& problem = *model.problem;
    std::vector<Border> borders(model.pieces.size());
    std::vector<int> pieces_in(rules.group_size.size(), 0), borders_of(rules.group_size.size(), 0);
    const auto group_of = [&](const Member& member) { return rules.group_of[at(member.element)]; };
    for (const Piece& piece : model.pieces) {
        std::vector<int> met;
        for (const Member& member : piece.members)
            if (group_of(member) >= 0 && std::find(met.begin(), met.end(), group_of(member)) == met.end()) {
                met.push_back(group_of(member));
                ++pieces_in[at(met.back())];
            }
    }
    for (int p = 0; p < model.piece_count(); ++p) {
        const auto& members = model.pieces[at(p)].members;
        std::vector<int> closed;
        for (std::size_t k = 0; k < members.size();) {
            const int group = group_of(members[k]);
            std::size_t end = k;
            while (end < members.size() && group_of(members[end]) == group) ++end;
            if (group >= 0) {
                const std::string name = named(problem, members[k].element);
                if (std::find(closed.begin(), closed.end(), group) != closed.end())
                    return fail(name, fmt::format("its chain of links leaves group {} and comes back", group),
                                "remove a link");
                closed.push_back(group);
                const bool whole = k == 0 && end == members.size();
                if (whole) {
                    if (pieces_in[at(group)] > 1 || members.size() == 1) inside[at(group)].push_back(p);
                } else if (pieces_in[at(group)] > 1) {
                    if (k != 0 && end != members.size())
                        return fail(
                            name,
                            fmt::format(
                                "its links lead out of group {} both ways, with more of the group to draw",
                                group),
                            "remove a link or empty the group");
                    if (++borders_of[at(group)] > 2)
                        return fail(name, fmt::format("is the third way out of group {}", group),
                                    "remove a link");
                    (k == 0 ? borders[at(p)].front : borders[at(p)].back) = group;
                }
            }
            k = end;
        }
    }
    return borders;
}

}  // namespace

Outcome<Blocks> build_blocks(const Model& model) {
    Blocks all;
    all.inside.resize(model.rules.group_size.size());
    const auto borders = find_borders(model, all.inside);
    if (!borders) return tl::unexpected(borders.error());
    const std::size_t groups = all.inside.size();
    std::vector<std::vector<int>> ways(groups);  // border pieces of each group
    for (int p = 0; p < model.piece_count(); ++p)
        for (const int g : {(*borders)[at(p)].front, (*borders)[at(p)].back})
            if (g >= 0) ways[at(g)].push_back(p);
    all.block_of.assign(model.pieces.size(), -1);
    all.item_of.assign(model.pieces.size(), 0);
    all.block_of_group.assign(groups, -1);
    std::vector<bool> used(model.pieces.size(), false);

    // From a piece (or a group) onwards, leaving each by the side that was not entered.
    const auto walk = [&](int piece, int group) {
        Block block;
        for (;;) {
            if (piece >= 0) {
                const Border& b = (*borders)[at(piece)];
                const bool from_front = group >= 0 ? b.front == group : b.front < 0;
                block.items.push_back({piece, -1, !from_front});
                used[at(piece)] = true;
                group = from_front ? b.back : b.front;
                if (group < 0) return block;
            }
            if (all.block_of_group[at(group)] == -2) return block;
            all.block_of_group[at(group)] = -2;
            block.items.push_back({-1, group, false});
            const int from = piece;
            piece = -1;
            for (const int p : ways[at(group)])
                if (p != from && !used[at(p)]) piece = p;
            if (piece < 0) return block;
        }
    };
    const auto add = [&](Block block) {
        const int b = static_cast<int>(all.blocks.size());
        for (std::size_t k = 0; k < block.items.size(); ++k) {
            const Item& item = block.items[k];
            const auto place = [&](int p) {
                all.block_of[at(p)] = b;
                all.item_of[at(p)] = static_cast<int>(k);
            };
            if (item.piece >= 0)
                place(item.piece);
            else {
                all.block_of_group[at(item.group)] = b;
                std::for_each(all.inside[at(item.group)].begin(), all.inside[at(item.group)].end(), place);
            }
        }
        all.blocks.push_back(std::move(block));
    };
    // Ends of rows: chains with one border, groups with at most one way out. What is left then is a ring.
    for (int p = 0; p < model.piece_count(); ++p) {
        const Border& b = (*borders)[at(p)];
        if (!used[at(p)] && (b.front < 0) != (b.back < 0)) add(walk(p, -1));
    }
    for (int g = 0; g < static_cast<int>(groups); ++g)
        if (all.block_of_group[at(g)] == -1 && ways[at(g)].size() <= 1 &&
            (!all.inside[at(g)].empty() || !ways[at(g)].empty()))
            add(walk(-1, g));
    for (int p = 0; p < model.piece_count(); ++p) {
        if (all.block_of[at(p)] >= 0) continue;
        const Border& b = (*borders)[at(p)];
        if (b.front >= 0)
            return fail(named(*model.problem, model.pieces[at(p)].members.front().element),
                        "its chain and its groups close on themselves", "remove a link");
        add(Block{{{p, -1, false}}, {true, true}});
    }
    return all;
}

namespace {

std::string circle_text(const Problem& problem, const std::vector<std::pair<int, int>>& labels,
                        const std::vector<std::size_t>& circle) {
    std::string text;
    for (const std::size_t e : circle) {
        const auto [i, j] = labels[e];
        text += fmt::format("{}{} before {}", text.empty() ? "" : ", ",
                            i < 0 ? fmt::format("group {}", -1 - i) : named(problem, i),
                            j < 0 ? fmt::format("group {}", -1 - j) : named(problem, j));
    }
    return text;
}

}  // namespace

/// Circles among blocks and inside groups; which way each block can be run.
Outcome<void> check_blocks(const Model& model, Blocks& all) {
    const Problem& problem = *model.problem;
    const Rules& rules = model.rules;
    std::vector<std::pair<int, int>> plain(rules.before), labels, inner, inner_labels;
    if (const auto circle = find_circle(static_cast<int>(model.piece_of.size()), plain); !circle.empty())
        return fail("before", circle_text(problem, plain, circle) + ": a circle", "drop one of them");
    const auto run_out = [&](Block& block, bool way, const std::string& why) -> Outcome<void> {
        block.runs[way] = false;
        if (block.runs[0] || block.runs[1]) return {};
        return fail("", why + " contradicts the other links, groups, directions and orders around it",
                    "drop one of them");
    };
    for (const auto& [i, j] : rules.before) {
        const int p = model.piece_of[at(i)], q = model.piece_of[at(j)];
        const int b = all.block_of[at(p)], c = all.block_of[at(q)];
        if (b != c) {
            all.edges.emplace_back(b, c);
            labels.emplace_back(i, j);
        } else if (all.item_of[at(p)] == all.item_of[at(q)]) {
            inner.emplace_back(p, q);
            inner_labels.emplace_back(i, j);
        } else {
            const bool listed = all.item_of[at(p)] < all.item_of[at(q)];
            const std::string why = fmt::format("{} before {}", named(problem, i), named(problem, j));
            if (const auto left = run_out(all.blocks[at(b)], listed, why); !left) return left;
        }
    }
    for (Block& block : all.blocks)
        for (const Item& item : block.items) {
            if (item.piece < 0 || block.items.size() == 1) continue;
            const int direction = model.pieces[at(item.piece)].direction;
            if (direction == 0) continue;
            const bool listed = (direction < 0) == item.backward;
            const std::string why = fmt::format(
                "the direction of {}", named(problem, model.pieces[at(item.piece)].members.front().element));
            if (const auto left = run_out(block, listed, why); !left) return left;
        }
    if (rules.keep_group_order) {
        // Where each group is met: its block and item. Groups inside one piece were settled when the model
        // was built.
        std::vector<std::pair<int, int>> met(rules.group_size.size(), {-1, -1});
        std::vector<int> piece_met(rules.group_size.size(), -1);
        for (std::size_t e = 0; e < rules.group_of.size(); ++e) {
            const int g = rules.group_of[e], p = model.piece_of[e];
            if (g < 0) continue;
            met[at(g)] = {all.block_of[at(p)], all.item_of[at(p)]};
            piece_met[at(g)] = p;
        }
        for (std::size_t b = 0; b < all.blocks.size(); ++b)
            for (std::size_t k = 0; k < all.blocks[b].items.size(); ++k)
                if (const int g = all.blocks[b].items[k].group; g >= 0)
                    met[at(g)] = {static_cast<int>(b), static_cast<int>(k)};
        int last = -1;
        for (int g = 0; g < static_cast<int>(met.size()); ++g) {
            if (met[at(g)].first < 0) continue;
            if (last >= 0) {
                if (met[at(last)].first != met[at(g)].first) {
                    all.edges.emplace_back(met[at(last)].first, met[at(g)].first);
                    labels.emplace_back(-1 - last, -1 - g);
                } else if (met[at(last)].second != met[at(g)].second) {
                    const std::string why = fmt::format("group {} before group {}", last, g);
                    if (const auto left = run_out(all.blocks[at(met[at(g)].first)],
                                                  met[at(last)].second < met[at(g)].second, why);
                        !left)
                        return left;
                }
            }
            last = g;
        }
    }
    if (const auto circle = find_circle(model.piece_count(), inner); !circle.empty())
        return fail("before", circle_text(problem, inner_labels, circle) + ": a circle, given the links",
                    "drop one of them");
    if (const auto circle = find_circle(static_cast<int>(all.blocks.size()), all.edges); !circle.empty())
        return fail("before", circle_text(problem, labels, circle) + ": a circle, given the links and groups",
                    "drop one of them");
    return {};
}

}  // namespace strandline::tour
