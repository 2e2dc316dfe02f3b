// Tour problems for solvers of others, and their tours (docs/stage-formats.md).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "math/geometry/geometry.hpp"
#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

/// A matrix of more is a file of a gigabyte.
constexpr std::size_t most_matrix_nodes = 10'000;
/// The far point lies so many diagonals away: nothing that an open tour saves makes up for passing it midway.
constexpr double far_away = 10;
/// Whole numbers that solvers still multiply by 100.
constexpr double longest_length = 1e7;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A way to pass an element.
struct Way {
    tour::Step step;
    Point in, out;
};

std::vector<Way> ways_of(const tour::Problem& problem, int number) {
    const tour::Element& element = problem.elements[at(number)];
    const int last = static_cast<int>(element.points.size()) - 1;
    std::vector<Way> ways;
    if (element.closed) {
        const bool reversed = element.sense != tour::Sense::any &&
                              (signed_area(element.points) > 0) != (element.sense == tour::Sense::ccw);
        for (int v = 0; v <= last; ++v)
            if (!element.entry || *element.entry == v)
                ways.push_back({{number, v, reversed}, element.points[at(v)], element.points[at(v)]});
        return ways;
    }
    for (const bool reversed : {false, true}) {
        const int entry = reversed ? last : 0;
        if (element.entry && *element.entry != entry) continue;
        if (element.direction == (reversed ? tour::Direction::forward : tour::Direction::backward)) continue;
        ways.push_back(
            {{number, entry, reversed}, element.points[at(entry)], element.points[at(last - entry)]});
    }
    return ways;
}

struct Ways {
    std::vector<Way> ways;           ///< by element
    std::vector<std::size_t> first;  ///< by element; one past the end too
};
Ways all_ways(const tour::Problem& problem) {
    Ways all;
    for (std::size_t i = 0; i < problem.elements.size(); ++i) {
        all.first.push_back(all.ways.size());
        const auto own = ways_of(problem, static_cast<int>(i));
        all.ways.insert(all.ways.end(), own.begin(), own.end());
    }
    all.first.push_back(all.ways.size());
    return all;
}

/// Whether coordinates say it all: lines that may be run either way, to anywhere.
bool is_plain(const tour::Problem& problem) {
    for (std::size_t i = 0; i < problem.elements.size(); ++i)
        if (problem.elements[i].closed || ways_of(problem, static_cast<int>(i)).size() < 2) return false;
    return problem.end != tour::End::at_point;
}

Box box_of(const tour::Problem& problem) {
    Box box;
    for (const tour::Element& element : problem.elements)
        for (const Point p : element.points) box = including(box, p);
    if (problem.start) box = including(box, *problem.start);
    if (problem.end == tour::End::at_point) box = including(box, problem.end_point);
    return box;
}

/// A power of ten, so that lengths up to `longest` stay whole numbers of at most seven digits.
double scale_for(double longest) {
    return longest > 0 ? std::pow(10, std::floor(std::log10(longest_length / longest))) : 1;
}

std::string written_lines(const tour::Problem& problem, const Box& box) {
    const double diagonal = distance(box.low, box.high), scale = scale_for((far_away + 2) * diagonal);
    const bool ring = problem.end == tour::End::at_start;
    const std::size_t n = problem.elements.size(), pairs = n + (problem.start && !ring ? 1 : 0),
                      nodes = 2 * pairs + (problem.start && ring ? 1 : 0);
    fmt::memory_buffer out;
    const auto write = [&](std::size_t node, Point p) {
        fmt::format_to(std::back_inserter(out), "{} {:.3f} {:.3f}\n", node, scale * p.x, scale * p.y);
    };
    fmt::format_to(std::back_inserter(out),
                   "NAME : strandline\nCOMMENT : {} tour; node 2i+1 and 2i+2 are the ends of line i; lengths "
                   "times {}\nTYPE : {}\nDIMENSION : {}\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n",
                   ring ? "a closed" : "an open", scale, ring ? "TSP" : "HPP", nodes);
    for (std::size_t i = 0; i < n; ++i) {
        write(2 * i + 1, problem.elements[i].points.front());
        write(2 * i + 2, problem.elements[i].points.back());
    }
    if (problem.start) write(2 * n + 1, *problem.start);
    if (pairs > n) {
        write(2 * n + 2, *problem.start - Point{far_away * diagonal, 0});
    }
    fmt::format_to(std::back_inserter(out), "FIXED_EDGES_SECTION\n");
    for (std::size_t i = 0; i < pairs; ++i)
        fmt::format_to(std::back_inserter(out), "{} {}\n", 2 * i + 1, 2 * i + 2);
    fmt::format_to(std::back_inserter(out), "-1\nEOF\n");
    return fmt::to_string(out);
}

/// Node 1 is start and end together.
Outcome<std::string> written_sets(const tour::Problem& problem, const Box& box) {
    const auto [ways, first] = all_ways(problem);
    if (ways.size() >= most_matrix_nodes)
        return fail("TSPLIB",
                    fmt::format("{} ways to pass the elements; a matrix is written for {} at most",
                                ways.size(), most_matrix_nodes - 1),
                    "thin out the closed lines' vertices");
    const double scale = scale_for(distance(box.low, box.high));
    fmt::memory_buffer out;
    fmt::format_to(
        std::back_inserter(out),
        "NAME : strandline\nCOMMENT : node 1 is start and end; a set for each element; lengths times "
        "{}\nTYPE : AGTSP\nDIMENSION : {}\nGTSP_SETS : {}\nEDGE_WEIGHT_TYPE : EXPLICIT\n"
        "EDGE_WEIGHT_FORMAT : FULL_MATRIX\nEDGE_WEIGHT_SECTION\n",
        scale, ways.size() + 1, problem.elements.size() + 1);
    const auto whole = [&](double length) {
        fmt::format_to(std::back_inserter(out), "{} ", std::lround(scale * length));
    };
    whole(0);
    for (const Way& to : ways) whole(problem.start ? distance(*problem.start, to.in) : 0);
    out.push_back('\n');
    for (const Way& from : ways) {
        whole(problem.end == tour::End::at_point                    ? distance(from.out, problem.end_point)
              : problem.end == tour::End::at_start && problem.start ? distance(from.out, *problem.start)
                                                                    : 0);
        for (const Way& to : ways) whole(distance(from.out, to.in));
        out.push_back('\n');
    }
    fmt::format_to(std::back_inserter(out), "GTSP_SET_SECTION\n1 1 -1\n");
    for (std::size_t i = 0; i + 1 < first.size(); ++i) {
        fmt::format_to(std::back_inserter(out), "{}", i + 2);
        for (std::size_t w = first[i]; w < first[i + 1]; ++w)
            fmt::format_to(std::back_inserter(out), " {}", w + 2);
        fmt::format_to(std::back_inserter(out), " -1\n");
    }
    fmt::format_to(std::back_inserter(out), "EOF\n");
    return fmt::to_string(out);
}

/// The numbers of the section, as they stand.
Outcome<std::vector<long>> numbers_of(std::string_view text, const std::string& place) {
    const std::size_t section = text.find("TOUR_SECTION");
    if (section == std::string_view::npos)
        return fail(place, "has no TOUR_SECTION", "give the tour file that the solver wrote");
    std::vector<long> numbers;
    std::size_t k = text.find('\n', section);
    long line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(section), '\n');
    while (k < text.size()) {
        if (text[k] == '\n') ++line;
        if (std::string_view(" \t\r\n").find(text[k]) != std::string_view::npos) {
            ++k;
            continue;
        }
        long number = 0;
        const auto [end, error] = std::from_chars(text.data() + k, text.data() + text.size(), number);
        if (number == -1 || text.substr(k, 3) == "EOF") break;
        if (error != std::errc{})
            return fail(fmt::format("{}, line {}", place, line), "is not a node's number",
                        "write one a line");
        numbers.push_back(number);
        k = static_cast<std::size_t>(end - text.data());
    }
    return numbers;
}

Outcome<std::vector<tour::Step>> steps_of_lines(std::vector<long> nodes, const std::string& place,
                                                const tour::Problem& problem) {
    const long n = static_cast<long>(problem.elements.size());
    if (problem.start && problem.end == tour::End::at_start) {
        const auto start = std::ranges::find(nodes, 2 * n + 1);
        if (start == nodes.end()) return fail(place, fmt::format("node {} is missing", 2 * n + 1));
        std::rotate(nodes.begin(), start, nodes.end());
        nodes.erase(nodes.begin());
    } else if (problem.start) {  // the far point in front, then the start
        const auto far = std::ranges::find(nodes, 2 * n + 2);
        if (far == nodes.end()) return fail(place, fmt::format("node {} is missing", 2 * n + 2));
        std::rotate(nodes.begin(), far, nodes.end());
        if (nodes.size() > 1 && nodes[1] != 2 * n + 1) std::reverse(nodes.begin() + 1, nodes.end());
        if (nodes.size() < 2 || nodes[1] != 2 * n + 1)
            return fail(place, fmt::format("node {} is not beside node {}", 2 * n + 1, 2 * n + 2),
                        "solve it with its fixed edges");
        nodes.erase(nodes.begin(), nodes.begin() + 2);
    } else if (nodes.size() > 2 && (nodes[0] - 1) / 2 != (nodes[1] - 1) / 2) {
        std::rotate(nodes.begin(), nodes.begin() + 1,
                    nodes.end());  // written as a ring that begins in a line
    }
    std::vector<tour::Step> steps;
    for (std::size_t k = 0; k + 1 < nodes.size(); k += 2) {
        if (nodes[k] < 1 || nodes[k] > 2 * n || (nodes[k] - 1) / 2 != (nodes[k + 1] - 1) / 2)
            return fail(place,
                        fmt::format("nodes {} and {} are not the two ends of a line", nodes[k], nodes[k + 1]),
                        "solve it with its fixed edges");
        const int element = static_cast<int>((nodes[k] - 1) / 2);
        const bool reversed = nodes[k] > nodes[k + 1];
        const int last = static_cast<int>(problem.elements[at(element)].points.size()) - 1;
        steps.push_back({element, reversed ? last : 0, reversed});
    }
    return steps;
}

Outcome<std::vector<tour::Step>> steps_of_sets(std::vector<long> nodes, const std::string& place,
                                               const tour::Problem& problem) {
    const std::vector<Way> ways = all_ways(problem).ways;
    const auto start = std::ranges::find(nodes, 1);
    if (start == nodes.end()) return fail(place, "node 1 is missing");
    std::rotate(nodes.begin(), start, nodes.end());
    std::vector<tour::Step> steps;
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        if (nodes[k] < 2 || at(static_cast<int>(nodes[k]) - 2) >= ways.size())
            return fail(place, fmt::format("there is no node {}", nodes[k]));
        steps.push_back(ways[at(static_cast<int>(nodes[k]) - 2)].step);
    }
    return steps;
}

}  // namespace

Outcome<std::string> write_tsplib(const tour::Problem& problem) {
    if (!problem.links.empty() || !problem.before.empty() || !problem.groups.empty())
        return fail("TSPLIB", "the problem has links, \"before\" or groups, which the format does not know",
                    "drop them");
    if (problem.elements.empty()) return fail("TSPLIB", "there is nothing to order", "add elements");
    const Box box = box_of(problem);
    if (is_plain(problem)) return written_lines(problem, box);
    return written_sets(problem, box);
}

Outcome<std::vector<tour::Step>> read_tsplib_tour(std::string_view text, const std::string& place,
                                                  const tour::Problem& problem) {
    auto nodes = numbers_of(text, place);
    if (!nodes) return tl::unexpected(nodes.error());
    return is_plain(problem) ? steps_of_lines(std::move(*nodes), place, problem)
                             : steps_of_sets(std::move(*nodes), place, problem);
}

}  // namespace strandline::stages
