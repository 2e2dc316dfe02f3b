#include "path/tour/assembly.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace strandline::tour {
namespace {

/// Longer circles are another tour altogether: their repair costs more than it finds.
constexpr std::size_t longest_circle = 400;
/// Nodes of the ring that is joined to another; larger ones are left.
constexpr int largest_ring = 1'000;
/// A circle that loses more than this share of the mean leg before the descent is not worth one.
constexpr double worst_loss = 0.5;
/// A circle that gained nothing may gain when its surroundings have changed: so often.
constexpr int most_tries = 10;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Links as they would be: those that differ from the tour's. One for many circles: clear() costs nothing.
class Plan {
  public:
    explicit Plan(const Sequence& tour)
        : tour_(tour), mates_(at(tour.nodes())), planned_(mates_.size(), 0), done_(mates_.size(), 0) {}
    void clear() {
        ++stamp_;
        nodes_.clear();
    }
    int mate(int node) const { return planned_[at(node)] == stamp_ ? mates_[at(node)] : tour_.mate(node); }
    void join(int a, int b) {
        set(a, b);
        set(b, a);
    }
    /// As circles of removed and new links; nodes whose link came back are left out.
    Change change() {
        ++turn_;
        t_.clear();
        circles_.clear();
        for (const int first : nodes_) {
            if (done_[at(first)] == turn_ || mates_[at(first)] == tour_.mate(first)) continue;
            int node = first;
            do {
                const int old = tour_.mate(node);
                done_[at(node)] = done_[at(old)] = turn_;
                t_.push_back(node);
                t_.push_back(old);
                node = mate(old);
            } while (node != first);
            circles_.push_back(static_cast<int>(t_.size()) / 2);
        }
        return {t_, circles_};
    }

  private:
    void set(int node, int mate) {
        if (planned_[at(node)] != stamp_) nodes_.push_back(node);
        planned_[at(node)] = stamp_;
        mates_[at(node)] = mate;
    }
    const Sequence& tour_;
    int stamp_ = 0, turn_ = 0;
    std::vector<int> mates_, planned_, done_, nodes_, t_, circles_;
};

/// The least costly way to join the smallest ring to another: links (a, its mate) and (b, its mate) become
/// a b and the two mates. Returns its cost; infinite when there is none below `limit`.
double join_smallest(const Search& search, Plan& plan, const std::vector<Run>& runs, int rings,
                     double limit) {
    const Sequence& tour = search.tour;
    const Model& model = tour.model();
    std::vector<int> size(at(rings), 0);
    for (const Run& run : runs) size[at(run.ring)] += run.count;
    const int ring = static_cast<int>(std::min_element(size.begin(), size.end()) - size.begin());
    constexpr double none = std::numeric_limits<double>::infinity();
    if (size[at(ring)] > largest_ring) return none;
    // Runs follow each other in the array; the last of them may wrap.
    const auto in_ring = [&](int place) {
        for (const Run& run : runs) {
            const int ahead = place - run.begin + (place < run.begin ? tour.nodes() : 0);
            if (ahead < run.count) return run.ring == ring;
        }
        return false;
    };
    const auto& lists = search.candidates;
    double best = limit;
    int best_a = -1, best_b = -1;
    for (const Run& run : runs) {
        if (run.ring != ring) continue;
        for (int i = 0, place = run.begin; i < run.count;
             ++i, place = place + 1 == tour.nodes() ? 0 : place + 1) {
            const int a = tour.node_at(place);
            if (a >= model.loose_from) continue;
            const int mate_a = plan.mate(a);
            const double link_a = tour.gap(a, mate_a);
            for (int c = lists.first[at(a)]; c < lists.first[at(a + 1)]; ++c) {
                const auto [b, exact, least] = lists.all[at(c)];
                if (least - link_a >= best) break;
                const int mate_b = plan.mate(b);
                const double cost = tour.gap(a, b) + tour.gap(mate_a, mate_b) - link_a - tour.gap(b, mate_b);
                if (cost >= best || in_ring(tour.place_of(b))) continue;
                best = cost;
                best_a = a;
                best_b = b;
            }
        }
    }
    if (best_a < 0) return none;
    const int mate_a = plan.mate(best_a), mate_b = plan.mate(best_b);
    plan.join(best_a, best_b);
    plan.join(mate_a, mate_b);
    return best;
}

/// The other tour's links by node. A polygon's two nodes lie on one point and may change their parts: they
/// are named so that as many links as can be lead to the same piece as ours.
std::vector<int> mates_like(const Sequence& tour, const Sequence& other) {
    const Model& model = tour.model();
    const auto renamed = [&](int node) {
        if (!model.is_polygon(node / 2)) return node;
        const int a = node & ~1, b = a + 1;
        const auto same = [&](int ours, int theirs) { return tour.mate(ours) / 2 == other.mate(theirs) / 2; };
        return same(a, b) + same(b, a) > same(a, a) + same(b, b) ? node ^ 1 : node;
    };
    std::vector<int> mates(at(tour.nodes()));
    for (int node = 0; node < tour.nodes(); ++node) mates[at(renamed(node))] = renamed(other.mate(node));
    return mates;
}

/// Circles of links (t0 t1), (t2 t3) ... of ours, with the other tour's t1 t2, t3 t4 ... between them.
std::vector<std::vector<int>> circles_between(const Sequence& tour, const std::vector<int>& mates) {
    std::vector<std::vector<int>> circles;
    std::vector<bool> seen(mates.size(), false);
    for (int first = 0; first < tour.nodes(); ++first) {
        if (seen[at(first)] || mates[at(first)] == tour.mate(first)) continue;
        std::vector<int> circle;
        int node = first;
        do {
            const int mate = tour.mate(node);
            seen[at(node)] = seen[at(mate)] = true;
            circle.push_back(node);
            circle.push_back(mate);
            node = mates[at(mate)];
        } while (node != first);
        circles.push_back(std::move(circle));
    }
    return circles;
}

/// Polygons of the circle take the other tour's vertices; the gain, as a rule below 0.
double take_choices(Search& search, const std::vector<int>& circle, const Sequence& other) {
    Sequence& tour = search.tour;
    double gain = 0;
    for (const int node : circle) {
        const int piece = node / 2;
        if (!tour.model().is_polygon(piece) || tour.choice(piece) == other.choice(piece)) continue;
        const int a = 2 * piece, b = a + 1;
        gain += tour.link(a) + tour.link(b);
        tour.choose(piece, other.choice(piece));
        gain -= tour.link(a) + tour.link(b);
        search.touched.insert(search.touched.end(), {tour.mate(a), tour.mate(b)});
    }
    return gain;
}

/// A number for the circle's removed and new links, whatever node it is read from.
std::uint64_t number_of(const std::vector<int>& circle) {
    const auto mixed = [](int a, int b) {
        const auto low = static_cast<std::uint64_t>(std::min(a, b)),
                   high = static_cast<std::uint64_t>(std::max(a, b));
        std::uint64_t x = (high << 32 | low) + 0x9e3779b97f4a7c15;  // splitmix64 (Steele, Lea, Flood 2014)
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
        x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
        return x ^ (x >> 31);
    };
    std::uint64_t removed = 0, added = 0;
    for (std::size_t i = 0; i < circle.size(); i += 2) {
        removed += mixed(circle[i], circle[i + 1]);
        added += mixed(circle[i + 1], circle[i + 2 < circle.size() ? i + 2 : 0]);
    }
    return removed + 3 * added;
}

/// The change a circle makes, its rings joined; empty when it cannot be had or loses too much.
Change assembled(const Search& search, Plan& plan, const std::vector<int>& circle, double& gain, double loss,
                 std::vector<Run>& runs) {
    const Sequence& tour = search.tour;
    gain = 0;
    for (std::size_t i = 0; i < circle.size(); i += 2) {
        const int a = circle[i + 1], b = circle[i + 2 < circle.size() ? i + 2 : 0];
        gain += tour.link(circle[i]) - tour.gap(a, b);
        plan.join(a, b);
    }
    Change change = plan.change();
    for (int rings = tour.rings(change, runs); rings > 1; rings = tour.rings(change, runs)) {
        gain -= join_smallest(search, plan, runs, rings, gain + loss);
        if (gain == -std::numeric_limits<double>::infinity()) return {};
        change = plan.change();
        if (change.t.empty()) return {};
    }
    return change;
}

}  // namespace

double absorb(Search& search, Descent& descent, const Sequence& other, Vain& vain) {
    Sequence& tour = search.tour;
    std::vector<std::vector<int>> circles = circles_between(tour, mates_like(tour, other));
    for (std::size_t k = circles.size(); k > 1; --k)
        std::swap(circles[k - 1], circles[at(below(search.random, static_cast<int>(k)))]);
    const double loss = worst_loss * tour.length() / std::max(1, tour.nodes() / 2);
    std::vector<Run> runs;
    Plan plan(tour);
    plan.clear();
    double total = 0;
    for (const std::vector<int>& circle : circles) {
        if (circle.size() > longest_circle || descent.ended()) continue;
        bool still_there = true;
        for (std::size_t i = 0; i < circle.size() && still_there; i += 2)
            still_there = tour.mate(circle[i]) == circle[i + 1];
        if (!still_there) continue;
        const std::uint64_t number = number_of(circle);
        if (const auto found = vain.find(number); found != vain.end() && found->second >= most_tries)
            continue;
        // Vertices first: the circle's links are measured between them.
        double gain = take_choices(search, circle, other), linked = 0;
        plan.clear();
        const Change change = assembled(search, plan, circle, linked, loss + gain, runs);
        gain += linked;
        if (change.t.empty() || gain < -loss) {
            search.touched.clear();
            tour.back(0);
            ++vain[number];
            continue;
        }
        tour.exchange(change);
        search.touched.insert(search.touched.end(), change.t.begin(), change.t.end());
        gain += descent.run();
        if (gain <= tour.model().tolerance || descent.ended()) {
            tour.back(0);
            ++vain[number];
        } else {
            total += gain;
        }
        tour.forget();
    }
    return total;
}

}  // namespace strandline::tour
