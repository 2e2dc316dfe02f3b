#include "path/tour/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "path/tour/order.hpp"

namespace strandline::tour {
namespace {

/// Elements of a part: so many times the root of all, within these.
constexpr double root_share = 1.5;
constexpr int fewest = 4, most = 40;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Parts {
  public:
    Parts(const Problem& problem, int size) : size_(size), part_(problem.elements.size(), 0) {
        for (const Element& element : problem.elements) {
            Box box;
            for (const Point p : element.points) box = including(box, p);
            middles_.push_back(0.5 * (box.low + box.high));
        }
    }

    void halve(std::vector<int>& elements, std::size_t begin, std::size_t end) {
        if (end - begin <= at(size_)) {
            for (std::size_t k = begin; k < end; ++k) part_[at(elements[k])] = count_;
            ++count_;
            return;
        }
        Box box;
        for (std::size_t k = begin; k < end; ++k) box = including(box, middles_[at(elements[k])]);
        const bool wide = box.width() >= box.height();
        const std::size_t half = begin + (end - begin) / 2;
        const auto first = elements.begin();
        using Step = std::vector<int>::difference_type;
        std::nth_element(first + static_cast<Step>(begin), first + static_cast<Step>(half),
                         first + static_cast<Step>(end), [&](int a, int b) {
                             const double p = wide ? middles_[at(a)].x : middles_[at(a)].y;
                             const double q = wide ? middles_[at(b)].x : middles_[at(b)].y;
                             return p != q ? p < q : a < b;
                         });
        halve(elements, begin, half);
        halve(elements, half, end);
    }
    int count() const { return count_; }
    int of(int element) const { return part_[at(element)]; }
    void unite(int a, int b) {
        for (int& part : part_)
            if (part == b) part = a;
    }

  private:
    int size_, count_ = 0;
    std::vector<int> part_;
    std::vector<Point> middles_;
};

}  // namespace

std::vector<std::vector<int>> neighbours(const Problem& problem, const std::vector<Step>& steps) {
    const int n = static_cast<int>(problem.elements.size());
    Parts parts(problem, std::clamp(static_cast<int>(std::lround(root_share * std::sqrt(n))), fewest, most));
    std::vector<int> group_of(at(n), -1);
    if (problem.groups.empty()) {
        std::vector<int> all(at(n));
        std::iota(all.begin(), all.end(), 0);
        parts.halve(all, 0, all.size());
    } else {
        for (std::size_t g = 0; g < problem.groups.size(); ++g) {
            std::vector<int> group = problem.groups[g];
            for (const int e : group) group_of[at(e)] = static_cast<int>(g);
            parts.halve(group, 0, group.size());
        }
    }
    for (const Link& link : problem.links) {
        const int a = parts.of(link.element_a), b = parts.of(link.element_b);
        if (a != b && group_of[at(link.element_a)] == group_of[at(link.element_b)]) parts.unite(a, b);
    }
    std::vector<std::pair<int, int>> edges;
    const auto find_edges = [&] {
        std::set<std::pair<int, int>> found;
        for (const auto& [i, j] : problem.before)
            if (parts.of(i) != parts.of(j) && group_of[at(i)] == group_of[at(j)])
                found.insert({parts.of(i), parts.of(j)});
        edges.assign(found.begin(), found.end());
        return find_circle(parts.count(), edges);
    };
    for (auto circle = find_edges(); !circle.empty(); circle = find_edges()) {
        const int kept = edges[circle.front()].first;
        for (const std::size_t edge : circle) parts.unite(kept, edges[edge].second);
    }

    // The part whose elements come earliest, on average, of those that nothing has to come before.
    struct Standing {
        int group = -1;
        double sum = 0;
        int waiting = 0;
        std::vector<int> elements;
    };
    std::vector<Standing> standing(at(parts.count()));
    for (std::size_t k = 0; k < steps.size(); ++k) {
        Standing& s = standing[at(parts.of(steps[k].element))];
        s.group = group_of[at(steps[k].element)];
        s.sum += static_cast<double>(k);
        s.elements.push_back(steps[k].element);
    }
    for (const auto& [a, b] : edges) ++standing[at(b)].waiting;
    std::vector<int> left;
    for (int p = 0; p < parts.count(); ++p)
        if (!standing[at(p)].elements.empty()) left.push_back(p);
    std::vector<std::vector<int>> order;
    while (!left.empty()) {
        const auto first = std::ranges::min_element(left, [&](int a, int b) {
            const Standing &s = standing[at(a)], &t = standing[at(b)];
            const bool s_waits = s.waiting > 0, t_waits = t.waiting > 0;
            if (s.group != t.group) return s.group < t.group;
            if (s_waits != t_waits) return t_waits;
            return s.sum * static_cast<double>(t.elements.size()) <
                   t.sum * static_cast<double>(s.elements.size());
        });
        const int p = *first;
        left.erase(first);
        for (const auto& [a, b] : edges)
            if (a == p) --standing[at(b)].waiting;
        order.push_back(standing[at(p)].elements);
    }
    return order;
}

}  // namespace strandline::tour
