// The cheapest taut string: A* over circles of one radius round the corners, of both senses, and the robot's
// own turning circles beside its poses. Links between corners are the ground's; tangents from starts and to
// ends are looked at against the ground only when their turn comes.
#include <algorithm>
#include <queue>

#include "path/route/string.hpp"

namespace strandline::route {
namespace {

/// Turns by less than this (radians) backwards are rounding.
constexpr double turn_slack = 1e-6;
/// A search that weighs blemishes takes no more nodes than this.
constexpr std::size_t most_weighed = 40;

/// The angle from one heading to another turning to `side`, in [0, 2 pi) but for rounding.
double turning(double from, double to, double side) {
    const double angle = side * wrap_angle(to - from);
    return angle < -turn_slack ? angle + 2 * pi : angle;
}

struct Label {
    double rank;       ///< cost so far and the least that is to come
    double cost;       ///< to the end of the edge
    int node, before;  ///< `before`: in `taken`, or -2 - the start's node
    Link edge;
    int link;  ///< its number among the links of the node before; -1: none of them
    bool looked_at;
    bool operator<(const Label& other) const {
        return rank != other.rank ? rank > other.rank : node > other.node;
    }
};

class Search {
  public:
    Search(const Quest& quest, const Bans& bans)
        : quest_(quest),
          bans_(bans),
          offset_(quest.ground.string_offset()),
          first_start_(2 * static_cast<int>(quest.ground.corners().size())),
          first_end_(first_start_ + 2 * static_cast<int>(quest.starts.size())),
          nodes_(first_end_ + 2 * static_cast<int>(quest.ends.size())),
          best_(static_cast<std::size_t>(first_start_), std::numeric_limits<double>::infinity()),
          target_(quest.ends.front().pose.at) {
        for (const Anchor& end : quest.ends) {
            spread_ = std::max(spread_, distance(end.pose.at, target_));
            least_after_ = std::min(least_after_, end.cost);
        }
        arcs_.assign(static_cast<std::size_t>(nodes_ - first_start_), -1);
    }

    std::optional<String> run() {
        if (!quest_.blemish_weight && !can_end()) return std::nullopt;
        for (int node = first_start_; node < first_end_; ++node) {
            const Anchor& anchor = start(node);
            queue_.push({anchor.cost + to_come(anchor.pose.at), anchor.cost, node, -1, {}, -1, true});
        }
        while (!queue_.empty()) {
            Label label = queue_.top();
            queue_.pop();
            if (label.rank > quest_.limit) break;
            if (is_start(label.node)) {
                expand(label.node, start(label.node).pose.heading, label.cost, -2 - label.node);
                continue;
            }
            if (dominated(label)) continue;
            if (!label.looked_at) {
                if (!look_at(label)) continue;
                if (!queue_.empty() && label.rank > queue_.top().rank) {
                    queue_.push(label);
                    continue;
                }
            }
            taken_.push_back(label);
            if (label.node >= first_end_) return string();
            if (quest_.blemish_weight && taken_.size() > most_weighed) break;
            best_[static_cast<std::size_t>(label.node)] = key(label);
            expand(label.node, label.edge.heading, label.cost, static_cast<int>(taken_.size()) - 1);
        }
        return std::nullopt;
    }

  private:
    bool is_corner(int node) const { return node < first_start_; }
    bool is_start(int node) const { return node >= first_start_ && node < first_end_; }
    double side_of(int node) const { return node % 2 ? 1 : -1; }
    const Corner& corner(int node) const {
        return quest_.ground.corners()[static_cast<std::size_t>(node / 2)];
    }
    const Anchor& start(int node) const {
        return quest_.starts[static_cast<std::size_t>((node - first_start_) / 2)];
    }
    const Anchor& end(int node) const {
        return quest_.ends[static_cast<std::size_t>((node - first_end_) / 2)];
    }
    const Corner* corner_or_none(int node) const { return is_corner(node) ? &corner(node) : nullptr; }
    Circle circle(int node) const {
        if (is_corner(node)) return {corner(node).at, offset_, side_of(node)};
        return beside(is_start(node) ? start(node).pose : end(node).pose, side_of(node), quest_.radii);
    }
    /// No more than what is to come from there.
    double to_come(Point p) const { return std::max(0.0, distance(p, target_) - spread_) + least_after_; }

    /// How far the robot's own circle at a start or end is clear, radians.
    double clear_arc(int node) const {
        const double side = side_of(node), radius = quest_.radii.of(side);
        if (radius == 0 || quest_.blemish_weight) return 2 * pi + 1;
        const bool forwards = is_start(node);
        Pose pose = forwards ? start(node).pose : end(node).pose;
        if (!forwards) pose.heading += pi;
        const double curvature = (forwards ? side : -side) / radius;
        const double arc = quest_.ground.clear_length({pose, {{2 * pi * radius, curvature, 0}}});
        return arc >= 2 * pi * radius ? 2 * pi + 1 : arc / radius;
    }

    /// Whether any straight part leads to an end: what cannot be come to is not searched for.
    bool can_end() {
        for (int last = first_end_; last < nodes_; ++last) {
            const Circle b = circle(last);
            const double arrives = end(last).pose.heading;
            for (int node = 0; node < first_end_; ++node) {
                const auto edge = taut_tangent(circle(node), corner_or_none(node), b, nullptr);
                if (edge && turning(heading(edge->ahead), arrives, b.side) <= arc_of(last) &&
                    quest_.ground.clear(edge->from, edge->to))
                    return true;
            }
        }
        return false;
    }

    /// What labels at one corner are compared by: the cost of having come round to the middle of its cone.
    double key(const Label& label) const {
        const double side = side_of(label.node);
        const Corner& c = corner(label.node);
        const double middle = heading(side * left_normal(c.before + c.after));
        return label.cost + offset_ * side * wrap_angle(middle - label.edge.heading);
    }
    bool dominated(const Label& label) const {
        return is_corner(label.node) && key(label) >= best_[static_cast<std::size_t>(label.node)];
    }

    /// Looks at the edge against the ground; false: it is refused.
    bool look_at(Label& label) const {
        label.looked_at = true;
        if (label.link >= 0)
            return quest_.ground.link_clear(taken_[static_cast<std::size_t>(label.before)].node,
                                            static_cast<std::size_t>(label.link));
        if (!quest_.blemish_weight) return quest_.ground.clear(label.edge.from, label.edge.to);
        const double extra = *quest_.blemish_weight * quest_.ground.blemish(label.edge.from, label.edge.to);
        label.cost += extra;
        label.rank += extra;
        return true;
    }

    bool banned(int before, int from, int node) const {
        if (bans_.empty()) return false;
        if (bans_.contains({-1, from, node})) return true;
        if (before < 0) return false;
        const Label& label = taken_[static_cast<std::size_t>(before)];
        const int first =
            label.before < 0 ? -2 - label.before : taken_[static_cast<std::size_t>(label.before)].node;
        return bans_.contains({first, from, node});
    }

    /// Pushes an edge from a node that was come to along `arrived` at `cost`.
    void push(int from, double arrived, double cost, int before, const Link& edge, int link) {
        const Circle a = circle(from);
        const double turn = turning(arrived, edge.heading, a.side);
        if (is_corner(from) ? turn > pi : turn > arc_of(from)) return;  // backwards, or over an obstacle
        if (banned(before, from, edge.node)) return;
        double total = cost + a.radius * turn + edge.length, rest = to_come(edge.to);
        if (!is_corner(edge.node)) {
            const Anchor& anchor = end(edge.node);
            const double last = turning(edge.heading, anchor.pose.heading, side_of(edge.node));
            if (last > arc_of(edge.node)) return;
            total += quest_.radii.of(side_of(edge.node)) * last + anchor.cost;
            rest = 0;
        }
        const Label label{total + rest, total, edge.node, before, edge, link, false};
        if (label.rank <= quest_.limit && !dominated(label)) queue_.push(label);
    }
    double arc_of(int node) {
        double& arc = arcs_[static_cast<std::size_t>(node - first_start_)];
        if (arc < 0) arc = clear_arc(node);
        return arc;
    }

    void expand(int from, double arrived, double cost, int before) {
        const Circle a = circle(from);
        const auto try_tangent = [&](int node) {
            const auto edge = taut_tangent(a, corner_or_none(from), circle(node), corner_or_none(node));
            if (edge)
                push(from, arrived, cost, before,
                     {node, edge->from, edge->to, heading(edge->ahead), edge->length}, -1);
        };
        if (is_corner(from) && !quest_.blemish_weight) {
            int number = 0;
            for (const Link& link : quest_.ground.links(from)) {
                if (link.state != Link::blocked) push(from, arrived, cost, before, link, number);
                ++number;
            }
        } else
            for (int node = 0; node < first_start_; ++node)
                if (node / 2 != from / 2) try_tangent(node);
        for (int node = first_end_; node < nodes_; ++node) try_tangent(node);
    }

    String string() const {
        const Label* label = &taken_.back();
        String result;
        result.cost = label->cost;
        result.end = static_cast<std::size_t>((label->node - first_end_) / 2);
        result.end_side = side_of(label->node);
        result.nodes.push_back(label->node);
        while (label->before >= 0) {
            label = &taken_[static_cast<std::size_t>(label->before)];
            result.bends.push_back({static_cast<std::size_t>(label->node / 2), side_of(label->node)});
            result.nodes.push_back(label->node);
        }
        const int first = -2 - label->before;
        result.start = static_cast<std::size_t>((first - first_start_) / 2);
        result.start_side = side_of(first);
        result.nodes.push_back(first);
        std::ranges::reverse(result.bends);
        std::ranges::reverse(result.nodes);
        return result;
    }

    const Quest& quest_;
    const Bans& bans_;
    double offset_;
    int first_start_, first_end_, nodes_;
    std::vector<double> best_;
    Point target_;
    double spread_ = 0, least_after_ = std::numeric_limits<double>::infinity();
    std::vector<double> arcs_;  ///< clear ones of starts and ends; -1: not asked for yet
    std::priority_queue<Label> queue_;
    std::vector<Label> taken_;
};

}  // namespace

Circle beside(Pose pose, double side, const TurningRadii& radii) {
    const double radius = radii.of(side);
    return {pose.at + side * radius * left_normal(unit(pose.heading)), radius, side};
}

std::optional<String> taut_string(const Quest& quest, const Bans& bans) { return Search(quest, bans).run(); }

double taut_length(const Ground& ground, Point from, Point to) {
    // circles of radius 0 beside a pose: points, and turning there costs nothing
    const std::vector<Anchor> starts{{{from, 0}, 0}}, ends{{{to, 0}, 0}};
    if (ground.clear(from, to)) return distance(from, to);
    const auto string = taut_string({ground, starts, ends, {0, 0}, {}}, {});
    return string ? string->cost : std::numeric_limits<double>::infinity();
}

}  // namespace strandline::route
