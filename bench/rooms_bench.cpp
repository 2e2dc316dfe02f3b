// Speed, a room at a time, on seeded inputs of our own.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

#include "input/drawing/drawing.hpp"
#include "input/svg/svg.hpp"
#include "machine/follow/follow.hpp"
#include "path/connect/connect.hpp"
#include "path/fill/fill.hpp"
#include "path/route/route.hpp"
#include "path/tour/tour.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "result/check/check.hpp"
#include "result/formats/formats.hpp"

namespace strandline {
namespace {

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

std::string drawing_text(const char* name) {
    std::ifstream file(std::string(STRANDLINE_SOURCE "/drawings/") + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// d = 0.1 to 20 R, all headings, random end curvatures. Argument: 0 quick, 1 refined, 2 fair, 3 spiro.
void connection(benchmark::State& state) {
    std::mt19937_64 random(20140704);
    std::vector<std::pair<CurvatureState, CurvatureState>> pairs;
    for (int i = 0; i < 1000; ++i) {
        const double d = 0.1 * std::pow(200, uniform(random, 0, 1));
        const auto any = [&](Point at) {
            const double heading = uniform(random, -pi, pi);
            return CurvatureState{{at, heading}, uniform(random, -1, 1)};
        };
        const CurvatureState from = any({0, 0}), to = any(d * unit(uniform(random, -pi, pi)));
        pairs.emplace_back(from, to);
    }
    using connect::Style;
    const Style styles[] = {Style::bounded, Style::bounded, Style::fair, Style::spiro};
    const connect::Options options{
        .style = styles[state.range(0)], .limits = {1, 2.5}, .refined = state.range(0) > 0};
    std::size_t i = 0;
    for (auto _ : state) {
        const auto& [from, to] = pairs[i++ % pairs.size()];
        benchmark::DoNotOptimize(connect::connection(from, to, options));
    }
}
BENCHMARK(connection)->DenseRange(0, 3);

/// 20 to 60 areas on 17 m of up to so many decimetres' radius (argument), random end headings, R 0.5 m,
/// clearance 0.25 m, sigma R^2 = 10; 20 ways a ground. Counters: shares of ways without a blemish, lengths
/// over the larger of taut string and Dubins, of those.
void route_way(benchmark::State& state) {
    std::mt19937_64 random(20140704);
    struct Case {
        CurvatureState from, to;
    };
    std::vector<Regions> worlds(20);
    std::vector<std::vector<Case>> cases(worlds.size());
    const auto point = [&] {
        const double x = uniform(random, 0, 17);
        return Point{x, uniform(random, 0, 17)};
    };
    const route::GroundOptions clearance{.clearance = 0.25};
    for (std::size_t w = 0; w < worlds.size(); ++w) {
        const auto count = 20 + random() % 41;
        for (std::size_t i = 0; i < count; ++i) {
            const Point centre = point();
            const double size = uniform(random, 0.3, static_cast<double>(state.range(0)) / 10);
            const auto corners = 4 + random() % 11;
            Region& area = worlds[w].emplace_back();
            for (std::size_t k = 0; k < corners; ++k)
                area.outer.push_back(
                    centre + size * uniform(random, 0.45, 1) *
                                 unit(2 * pi * static_cast<double>(k) / static_cast<double>(corners)));
        }
        route::Ground ground(clearance);
        ground.add(worlds[w]);
        const auto any = [&] {
            for (;;) {
                const Point at = point();
                const double heading = uniform(random, -pi, pi);
                if (ground.clear(at)) return CurvatureState{{at, heading}, 0};
            }
        };
        for (int i = 0; i < 20; ++i) {
            const CurvatureState from = any();
            cases[w].push_back({from, any()});
        }
    }
    const route::Options options{.limits = {0.5, 40}};
    std::vector<double> ratios;
    for (auto _ : state)
        for (std::size_t w = 0; w < worlds.size(); ++w) {
            state.PauseTiming();
            route::Ground ground(clearance);
            ground.add(worlds[w]);
            state.ResumeTiming();
            for (const Case& c : cases[w]) {
                const route::Way way = route::way(ground, c.from, c.to, options);
                state.PauseTiming();
                const double least = std::max(route::taut_length(ground, c.from.pose.at, c.to.pose.at),
                                              dubins_length(c.from.pose, c.to.pose, options.limits.radius));
                if (way.blemish == 0) ratios.push_back(length(way.curve) / least);
                state.ResumeTiming();
            }
        }
    std::ranges::sort(ratios);
    const auto ways = static_cast<double>(state.iterations()) * 400;
    const auto share = [&](double q) {
        return ratios[static_cast<std::size_t>(q * static_cast<double>(ratios.size() - 1))];
    };
    state.counters["clear"] = static_cast<double>(ratios.size()) / ways;
    state.counters["p50"] = share(0.5);
    state.counters["p95"] = share(0.95);
    state.counters["ways"] =
        benchmark::Counter(ways, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(route_way)->Arg(6)->Arg(12)->Unit(benchmark::kMillisecond);

void svg_read(benchmark::State& state) {
    const std::string text = drawing_text("mandala.svg");
    for (auto _ : state) benchmark::DoNotOptimize(svg::read(text));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(svg_read);

/// 20 MB, 300,000 cubic segments in 30,000 paths with classes, as a large map or tracing has them.
void svg_read_20_mb(benchmark::State& state) {
    std::mt19937_64 random(20140704);
    std::string text = "<svg viewBox='0 0 1000 1000'><style>";
    const auto put = [&](const char* before, auto number) {
        text += before;
        text += std::to_string(number);
    };
    for (int i = 0; i < 500; ++i) {
        put(".c", i);
        put("{fill:#", 100 + i);
        text += '}';
    }
    text += "</style>";
    for (int i = 0; i < 30'000; ++i) {
        put("<path class='c", i % 500);
        put("' d='M", uniform(random, 0, 1000));
        put(" ", uniform(random, 0, 1000));
        put(" c", 0);
        for (int k = 1; k < 60; ++k) put(" ", uniform(random, -3, 3));
        text += "z'/>\n";
    }
    for (auto _ : state) benchmark::DoNotOptimize(svg::read(text));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(svg_read_20_mb)->Unit(benchmark::kMillisecond);

void drawing_made(benchmark::State& state) {
    const auto document = svg::read(drawing_text("mandala.svg"));
    const Robot robot = *builtin_robot("beachbot");
    for (auto _ : state) benchmark::DoNotOptimize(make_drawing(*document, robot, {}));
}
BENCHMARK(drawing_made);

void curve_continuous_curvature(benchmark::State& state) {
    std::mt19937_64 random(20140704);
    const auto pose = [&](double reach) {
        const double a = uniform(random, -pi, pi);
        return CurvatureState{{reach * unit(a), uniform(random, -pi, pi)}, uniform(random, -2, 2)};
    };
    for (auto _ : state)
        benchmark::DoNotOptimize(
            continuous_curvature(pose(0), pose(0.05 * std::pow(200, uniform(random, 0, 1))), {0.5, 10}));
}
BENCHMARK(curve_continuous_curvature);

void follow_100_m(benchmark::State& state) {
    const Robot robot = *builtin_robot("beachbot");
    Curve curve{{{0, 0}, 0}, {}};
    for (int i = 0; i < 50; ++i) curve.pieces.push_back({2, i % 2 ? 1.0 : -1.0, i % 2 ? -1.0 : 1.0});
    for (auto _ : state) benchmark::DoNotOptimize(robot_path_for({curve}, robot));
}
BENCHMARK(follow_100_m);

void fill_ring(benchmark::State& state) {
    Region region;
    for (int i = 0; i < 100; ++i)
        region.outer.push_back((5 + 0.5 * std::sin(0.5 * i)) * unit(2 * pi * i / 100));
    region.holes.push_back({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}});
    fill::Options options;
    options.style = state.range(0) ? fill::Style::zigzag : fill::Style::spiral;
    for (auto _ : state) benchmark::DoNotOptimize(fill::fill_region(region, 0, "ring", options));
}
BENCHMARK(fill_ring)->ArgNames({"zigzag"})->Arg(0)->Arg(1);

void tour_lines(benchmark::State& state) {
    std::mt19937_64 random(1);
    tour::Problem problem;
    const double side = 100 * std::sqrt(static_cast<double>(state.range(0)));
    for (int i = 0; i < state.range(0); ++i) {
        const Point a{uniform(random, 0, side), uniform(random, 0, side)};
        tour::Element line;
        line.points = {a, a + uniform(random, 10, 150) * unit(uniform(random, -pi, pi))};
        problem.elements.push_back(line);
    }
    for (auto _ : state) benchmark::DoNotOptimize(tour::solve(problem));
}
BENCHMARK(tour_lines)->Arg(12)->Arg(100)->Unit(benchmark::kMillisecond);

void plan_whole(benchmark::State& state) {
    const std::string text = drawing_text("starfish.svg");
    const Robot robot = *builtin_robot("beachbot");
    for (auto _ : state) benchmark::DoNotOptimize(make_plan({text, "starfish.svg"}, robot, {}));
}
BENCHMARK(plan_whole)->Unit(benchmark::kMillisecond);

void check_proves(benchmark::State& state) {
    const auto plan =
        make_plan({drawing_text("starfish.svg"), "starfish.svg"}, *builtin_robot("beachbot"), {});
    for (auto _ : state) benchmark::DoNotOptimize(check::prove(*plan));
}
BENCHMARK(check_proves)->Unit(benchmark::kMillisecond);

void formats_round_trip(benchmark::State& state) {
    const auto plan =
        make_plan({drawing_text("starfish.svg"), "starfish.svg"}, *builtin_robot("beachbot"), {});
    for (auto _ : state) benchmark::DoNotOptimize(formats::read_plan(formats::write_plan(*plan), "bench"));
}
BENCHMARK(formats_round_trip)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace strandline
