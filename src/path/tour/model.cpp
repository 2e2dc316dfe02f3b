#include "path/tour/model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "path/tour/hilbert.hpp"

namespace strandline::tour {
namespace {

/// Squares of coordinates beyond this overflow a double.
constexpr double largest_coordinate = 1e150;
/// Gains smaller than this share of the drawing's size are rounding.
constexpr double rounding_share = 1e-12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }
int count(const Element& element) { return static_cast<int>(element.points.size()); }
/// One that is left where it was entered: a polygon, or a line of a single point.
bool is_spot(const Element& element) { return element.closed || element.points.size() == 1; }

tl::unexpected<Error> wrong(const Problem& problem, int element, std::string reason,
                            std::string remedy = {}) {
    return fail(named(problem, element), std::move(reason), std::move(remedy));
}

Outcome<void> check_points(const Problem& problem) {
    const auto sound = [](Point p) {
        return is_finite(p) && std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate;
    };
    for (int i = 0; i < static_cast<int>(problem.elements.size()); ++i) {
        const Element& element = problem.elements[at(i)];
        if (element.points.empty()) return wrong(problem, i, "has no points", "remove it or give it points");
        for (std::size_t k = 0; k < element.points.size(); ++k)
            if (!sound(element.points[k]))
                return wrong(problem, i, fmt::format("point {} is not finite or too large", k),
                             "give numbers of ordinary size");
    }
    if (problem.start && !sound(*problem.start)) return fail("start", "is not finite or too large");
    if (problem.end == End::at_point && !sound(problem.end_point))
        return fail("end", "is not finite or too large");
    return {};
}

Outcome<void> check_entries(const Problem& problem) {
    for (int i = 0; i < static_cast<int>(problem.elements.size()); ++i) {
        const Element& element = problem.elements[at(i)];
        if (!element.entry) continue;
        const int entry = *element.entry, last = count(element) - 1;
        if (entry < 0 || entry > last)
            return wrong(problem, i,
                         fmt::format("its entry is vertex {}, but it has {} points", entry, last + 1));
        if (element.closed) continue;
        if (entry != 0 && entry != last)
            return wrong(problem, i, fmt::format("its entry is vertex {}, inside an open line", entry),
                         fmt::format("use 0 or {}", last));
        const bool clash = last > 0 && ((entry == 0 && element.direction == Direction::backward) ||
                                        (entry != 0 && element.direction == Direction::forward));
        if (clash)
            return wrong(problem, i, "its fixed entry and its direction contradict each other",
                         "drop one of them");
    }
    return {};
}

/// Node of an element at which a link may hold: 0 first end, 1 last end (spots: always 0).
struct Hold {
    int vertex, other;
};
using Holds = std::vector<std::vector<Hold>>;

Outcome<Holds> check_links(const Problem& problem) {
    const int n = static_cast<int>(problem.elements.size());
    Holds holds(at(n));
    std::set<std::pair<int, int>> seen;
    for (std::size_t l = 0; l < problem.links.size(); ++l) {
        const Link& link = problem.links[l];
        const std::string place = fmt::format("link {}", l);
        for (const auto& [element, vertex] :
             {std::pair(link.element_a, link.vertex_a), std::pair(link.element_b, link.vertex_b)}) {
            if (element < 0 || element >= n)
                return fail(place, fmt::format("there is no element {}", element));
            if (vertex < 0 || vertex >= count(problem.elements[at(element)]))
                return fail(place, fmt::format("{} has no point {}", named(problem, element), vertex));
        }
        if (link.element_a == link.element_b)
            return fail(place, fmt::format("links {} to itself", named(problem, link.element_a)),
                        "remove it");
        if (!seen.insert(std::minmax(link.element_a, link.element_b)).second)
            return fail(place,
                        fmt::format("links {} and {} a second time", named(problem, link.element_a),
                                    named(problem, link.element_b)),
                        "remove one of the two");
        for (const auto& [element, vertex, other] :
             {std::tuple(link.element_a, link.vertex_a, link.element_b),
              std::tuple(link.element_b, link.vertex_b, link.element_a)}) {
            const Element& e = problem.elements[at(element)];
            auto& own = holds[at(element)];
            if (own.size() == 2)
                return fail(place, fmt::format("is the third one at {}", named(problem, element)),
                            "keep two");
            if (!is_spot(e) && vertex != 0 && vertex != count(e) - 1)
                return fail(
                    place,
                    fmt::format("holds the open {} at its inner point {}", named(problem, element), vertex),
                    fmt::format("use 0 or {}", count(e) - 1));
            if (!own.empty() && !is_spot(e) && own[0].vertex == vertex)
                return fail(place,
                            fmt::format("is the second one at point {} of the open {}", vertex,
                                        named(problem, element)),
                            "use its other end");
            if (!own.empty() && is_spot(e) && own[0].vertex != vertex)
                return fail(
                    place,
                    fmt::format(
                        "the closed {} is linked at points {} and {}, but it is left where it is entered",
                        named(problem, element), own[0].vertex, vertex),
                    "link both at one point");
            if (is_spot(e) && e.entry && *e.entry != vertex)
                return fail(place, fmt::format("holds {} at point {}, but its fixed entry is {}",
                                               named(problem, element), vertex, *e.entry));
            own.push_back({vertex, other});
        }
    }
    return holds;
}

/// +1: must be run from its first point, -1: from its last, 0: either.
int own_direction(const Element& element) {
    if (is_spot(element)) return 0;
    if (element.entry) return *element.entry == 0 ? 1 : -1;
    return element.direction == Direction::forward ? 1 : element.direction == Direction::backward ? -1 : 0;
}

/// The member as it is run when it is entered from its neighbour over hold `in` (-1: the chain starts here).
Member member_of(const Problem& problem, int element, const std::vector<Hold>& own, int in) {
    const Element& e = problem.elements[at(element)];
    if (is_spot(e)) {
        const int vertex = own.empty() ? e.entry.value_or(0) : own[0].vertex;
        return {element, vertex, vertex};
    }
    const int last = count(e) - 1;
    bool forward = true;
    if (in >= 0)
        forward = own[at(in)].vertex == 0;
    else if (!own.empty())
        forward = own[0].vertex == last;
    return forward ? Member{element, 0, last} : Member{element, last, 0};
}

Outcome<void> add_piece(Model& model, const Holds& holds, int first) {
    const Problem& problem = *model.problem;
    Piece piece;
    int element = first, in = -1;
    int decided_by = -1;
    for (;;) {
        const auto& own = holds[at(element)];
        const Member member = member_of(problem, element, own, in);
        const Element& e = problem.elements[at(element)];
        const int wanted = own_direction(e) * (member.entry == 0 ? 1 : -1);
        if (wanted != 0) {
            if (piece.direction == -wanted)
                return wrong(problem, element,
                             fmt::format("its direction contradicts that of {} in the same chain of links",
                                         named(problem, decided_by)),
                             "free one of the directions or remove a link");
            if (piece.direction == 0) decided_by = element;
            piece.direction = wanted;
        }
        model.piece_of[at(element)] = model.piece_count();
        piece.members.push_back(member);
        const int out = in < 0 ? 0 : 1 - in;
        if (out >= static_cast<int>(own.size())) break;
        const int next = own[at(out)].other;
        in = holds[at(next)][0].other == element ? 0 : 1;
        element = next;
    }
    const Member &front = piece.members.front(), &back = piece.members.back();
    const Element& only = problem.elements[at(front.element)];
    if (piece.members.size() == 1 && only.closed && !only.entry && only.points.size() > 1) {
        piece.first_choice = static_cast<int>(model.choices.size());
        piece.choices = count(only);
        for (int v = 0; v < count(only); ++v) model.choices.push_back({only.points[at(v)], v});
    }
    model.ends.push_back(only.points[at(front.entry)]);
    model.ends.push_back(problem.elements[at(back.element)].points[at(back.exit)]);
    model.rules.directed = model.rules.directed || piece.direction != 0;
    model.pieces.push_back(std::move(piece));
    return {};
}

/// What must precede what inside one piece decides which way the piece is run.
Outcome<void> turn_pieces(Model& model) {
    const Problem& problem = *model.problem;
    Rules& rules = model.rules;
    std::vector<int> place(model.piece_of.size());
    for (const Piece& piece : model.pieces)
        for (std::size_t k = 0; k < piece.members.size(); ++k)
            place[at(piece.members[k].element)] = static_cast<int>(k);
    const auto turn = [&](int i, int j) -> Outcome<void> {
        Piece& piece = model.pieces[at(model.piece_of[at(i)])];
        const int wanted = place[at(i)] < place[at(j)] ? 1 : -1;
        if (piece.direction == -wanted)
            return wrong(problem, i,
                         fmt::format("must come before {}, but the links, directions or other orders of "
                                     "their chain say otherwise",
                                     named(problem, j)),
                         "drop one of them");
        piece.direction = wanted;
        rules.directed = true;
        return {};
    };
    for (const auto& [i, j] : rules.before)
        if (model.piece_of[at(i)] == model.piece_of[at(j)])
            if (const auto turned = turn(i, j); !turned) return turned;
    std::erase_if(rules.before, [&](auto& pair) {
        return model.piece_of[at(pair.first)] == model.piece_of[at(pair.second)];
    });
    if (!rules.keep_group_order) return {};
    for (std::size_t p = 0; p < model.pieces.size(); ++p) {
        int last = -1;
        for (const Member& member : model.pieces[p].members) {
            if (rules.group_of[at(member.element)] < 0) continue;
            if (last >= 0) {
                const int a = rules.group_of[at(last)], b = rules.group_of[at(member.element)];
                if (a != b)
                    if (const auto turned = a < b ? turn(last, member.element) : turn(member.element, last);
                        !turned)
                        return turned;
            }
            last = member.element;
        }
    }
    return {};
}

Outcome<void> add_rules(Model& model) {
    const Problem& problem = *model.problem;
    const int n = static_cast<int>(problem.elements.size());
    Rules& rules = model.rules;
    rules.keep_group_order = problem.keep_group_order;
    for (std::size_t k = 0; k < problem.before.size(); ++k) {
        const auto [i, j] = problem.before[k];
        const std::string place = fmt::format("before {}", k);
        for (const int e : {i, j})
            if (e < 0 || e >= n) return fail(place, fmt::format("there is no element {}", e));
        if (i == j)
            return fail(place, fmt::format("{} cannot come before itself", named(problem, i)), "remove it");
        rules.before.emplace_back(i, j);
    }
    std::sort(rules.before.begin(), rules.before.end());
    rules.before.erase(std::unique(rules.before.begin(), rules.before.end()), rules.before.end());
    rules.group_of.assign(at(n), -1);
    for (const auto& group : problem.groups) {
        const int g = static_cast<int>(rules.group_size.size());
        for (const int e : group) {
            const std::string place = fmt::format("group {}", g);
            if (e < 0 || e >= n) return fail(place, fmt::format("there is no element {}", e));
            if (rules.group_of[at(e)] >= 0)
                return fail(
                    place, fmt::format("{} is in group {} already", named(problem, e), rules.group_of[at(e)]),
                    "put it into one group only");
            rules.group_of[at(e)] = g;
        }
        rules.group_size.push_back(static_cast<int>(group.size()));
    }
    if (const auto turned = turn_pieces(model); !turned) return turned;
    rules.any =
        rules.directed || !rules.before.empty() ||
        std::any_of(rules.group_size.begin(), rules.group_size.end(), [](int size) { return size > 0; });
    return {};
}

void add_gate(Model& model) {
    const Problem& problem = *model.problem;
    const bool closed = problem.end == End::at_start;
    model.gate = !(closed && !problem.start);
    model.loose_from = model.node_count();
    if (!model.gate) return;
    const int first = model.node_count();
    const bool start_loose = !problem.start, end_loose = problem.end == End::free;
    // Loose nodes come last, so that one comparison tells them.
    const bool swapped = start_loose && !end_loose;
    model.gate_start = swapped ? first + 1 : first;
    model.gate_end = swapped ? first : first + 1;
    model.loose_from = first + 2 - (start_loose ? 1 : 0) - (end_loose ? 1 : 0);
    model.ends.resize(at(first + 2));
    if (problem.start) model.ends[at(model.gate_start)] = *problem.start;
    if (!end_loose) model.ends[at(model.gate_end)] = closed ? *problem.start : problem.end_point;
}

}  // namespace

std::string named(const Problem& problem, int element) {
    const std::string& name = problem.elements[at(element)].name;
    return name.empty() ? fmt::format("element {}", element) : fmt::format("element {} ({})", element, name);
}

namespace {

/// More elements than this do not fit the processor's caches: what is near is numbered alike. Half the time
/// of a move at 100,000 lines.
constexpr int most_as_given = 1'000;

std::vector<int> numbering(const Problem& problem) {
    const int n = static_cast<int>(problem.elements.size());
    const bool plain = problem.links.empty() && problem.before.empty() && problem.groups.empty();
    if (plain && n > most_as_given) {
        std::vector<Point> middles;
        middles.reserve(at(n));
        for (const Element& e : problem.elements)
            middles.push_back(between(e.points.front(), e.points.back(), 0.5));
        return along_hilbert_curve(middles);
    }
    std::vector<int> numbers(at(n));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

}  // namespace

Outcome<Model> build_model(const Problem& problem) {
    if (const auto sound = check_points(problem); !sound) return tl::unexpected(sound.error());
    if (const auto sound = check_entries(problem); !sound) return tl::unexpected(sound.error());
    const auto holds = check_links(problem);
    if (!holds) return tl::unexpected(holds.error());

    Model model;
    model.problem = &problem;
    const int n = static_cast<int>(problem.elements.size());
    model.piece_of.assign(at(n), -1);
    for (const int e : numbering(problem)) {
        // A chain is read from its end with the lower number; one that has no end is a ring.
        if (model.piece_of[at(e)] >= 0 || (*holds)[at(e)].size() == 2) continue;
        if (const auto added = add_piece(model, *holds, e); !added) return tl::unexpected(added.error());
    }
    for (int e = 0; e < n; ++e)
        if (model.piece_of[at(e)] < 0)
            return wrong(problem, e, "is in a chain of links that closes on itself", "remove one link");
    if (const auto added = add_rules(model); !added) return tl::unexpected(added.error());
    add_gate(model);

    Box box;
    for (const Choice& choice : model.choices) box = including(box, choice.at);
    for (int node = 0; node < model.loose_from; ++node) box = including(box, model.ends[at(node)]);
    model.tolerance = box.empty() ? 0 : rounding_share * (box.width() + box.height());
    return model;
}

std::vector<Step> steps_of(const Model& model, const std::vector<Visit>& order) {
    std::vector<Step> steps;
    steps.reserve(model.piece_of.size());
    for (const Visit& visit : order) {
        const Piece& piece = model.pieces[at(visit.piece)];
        const int size = static_cast<int>(piece.members.size());
        for (int k = 0; k < size; ++k) {
            const Member& member = piece.members[at(visit.backward ? size - 1 - k : k)];
            const Element& element = model.problem->elements[at(member.element)];
            int entry = visit.backward ? member.exit : member.entry;
            bool reversed = entry != 0;
            if (element.closed) {
                if (piece.choices > 0) entry = model.choices[at(piece.first_choice + visit.choice)].vertex;
                // The sense costs nothing; points run counter-clockwise when their area is positive.
                reversed = element.sense != Sense::any &&
                           (signed_area(element.points) > 0) != (element.sense == Sense::ccw);
            } else if (element.points.size() == 1) {
                reversed = element.direction == Direction::backward;
            }
            steps.push_back({member.element, entry, reversed});
        }
    }
    return steps;
}

Point entry_of(const Problem& problem, const Step& step) {
    return problem.elements[at(step.element)].points[at(step.entry)];
}

Point exit_of(const Problem& problem, const Step& step) {
    const Element& e = problem.elements[at(step.element)];
    return e.closed ? e.points[at(step.entry)] : step.entry == 0 ? e.points.back() : e.points.front();
}

double length_of(const Problem& problem, const std::vector<Step>& steps) {
    if (steps.empty()) return 0;
    const Point first = entry_of(problem, steps.front()), last = exit_of(problem, steps.back());
    double sum = problem.start ? distance(*problem.start, first) : 0;
    for (std::size_t k = 1; k < steps.size(); ++k)
        sum += distance(exit_of(problem, steps[k - 1]), entry_of(problem, steps[k]));
    if (problem.end == End::at_point) sum += distance(last, problem.end_point);
    if (problem.end == End::at_start) sum += distance(last, problem.start ? *problem.start : first);
    return sum;
}

}  // namespace strandline::tour
