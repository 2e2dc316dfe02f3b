// The tangents between corners that are clear, as far as they were asked for.
#include <algorithm>

#include "path/route/string.hpp"

namespace strandline::route {
namespace {

constexpr double cone_slack = 1e-6;

/// Of the straight part between two circles.
struct Direction {
    Point ahead;     ///< times `squared`
    double squared;  ///< of the distance of the centres; 0: there is no such part
    double length;
};
Direction direction(const Circle& a, const Circle& b) {
    const Point d = b.centre - a.centre;
    const double across = b.side * b.radius - a.side * a.radius, squared = dot(d, d);
    if (squared <= across * across) return {{}, 0, 0};
    const double along = std::sqrt(squared - across * across);
    return {along * d - across * left_normal(d), squared, along};
}
Tangent tangent_along(const Circle& a, const Circle& b, const Direction& way) {
    const Point ahead = (1 / way.squared) * way.ahead, left = left_normal(ahead);
    return {a.centre - a.side * a.radius * left, b.centre - b.side * b.radius * left, ahead, way.length};
}

/// Whether a string that runs along `ahead` (of any length) round the corner touches it there and not at an
/// edge.
bool touches(const Corner& corner, double side, Point ahead, double slack) {
    const Point normal = -side * left_normal(ahead);
    return cross(corner.before, normal) >= -slack && cross(normal, corner.after) >= -slack &&
           dot(normal, corner.before + corner.after) > 0;
}

}  // namespace

std::optional<Tangent> tangent(const Circle& a, const Circle& b) {
    return taut_tangent(a, nullptr, b, nullptr);
}

std::optional<Tangent> taut_tangent(const Circle& a, const Corner* at_a, const Circle& b,
                                    const Corner* at_b) {
    const Direction way = direction(a, b);
    const double slack = cone_slack * way.squared;
    if (way.squared <= 0 || (at_a && !touches(*at_a, a.side, way.ahead, slack)) ||
        (at_b && !touches(*at_b, b.side, way.ahead, slack)))
        return std::nullopt;
    return tangent_along(a, b, way);
}

void Ground::add_links(int node, std::size_t first_corner, std::vector<Link>& list) const {
    const auto own = static_cast<std::size_t>(node / 2);
    const Circle a{corners_[own].at, string_offset(), node % 2 ? 1.0 : -1.0};
    for (std::size_t k = first_corner; k < corners_.size(); ++k)
        for (const double side : {-1.0, 1.0}) {
            if (k == own) continue;
            const auto edge = taut_tangent(a, &corners_[own], {corners_[k].at, a.radius, side}, &corners_[k]);
            if (edge)
                list.push_back({static_cast<int>(2 * k) + (side > 0 ? 1 : 0), edge->from, edge->to,
                                heading(edge->ahead), edge->length});
        }
}

std::span<const Link> Ground::links(int node) const {
    links_.resize(2 * corners_.size());
    Links& links = links_[static_cast<std::size_t>(node)];
    if (links.added < added_.size()) {
        const std::span<const Box> news = std::span(added_).subspan(links.added);
        for (Link& link : links.list) {
            const Box box = including(including(Box{}, link.from), link.to);
            if (link.state == Link::clear &&
                std::ranges::any_of(news, [&](const Box& added) { return overlaps(box, added); }))
                link.state = Link::unknown;
        }
        add_links(node, links.corners, links.list);
        links.added = added_.size();
        links.corners = corners_.size();
    }
    return links.list;
}

bool Ground::link_clear(int node, std::size_t index) const {
    Link& link = links_[static_cast<std::size_t>(node)].list[index];
    if (link.state == Link::unknown) link.state = clear(link.from, link.to) ? Link::clear : Link::blocked;
    return link.state == Link::clear;
}

}  // namespace strandline::route
