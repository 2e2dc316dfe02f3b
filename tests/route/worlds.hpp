#pragma once
// Random ground, and an exhaustive search to measure by.
#include <cmath>
#include <queue>
#include <random>
#include <set>
#include <tuple>

#include "path/route/route.hpp"

namespace strandline::testing {

/// 20 to 60 areas on 17 m, each with 4 to 14 corners, up to 2.4 m across; they may overlap.
class Worlds {
  public:
    explicit Worlds(unsigned seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    int whole(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
    }
    Point point() {
        const double x = uniform(0, 17);
        return {x, uniform(0, 17)};
    }
    Regions areas() {
        Regions result(static_cast<std::size_t>(whole(20, 60)));
        for (Region& area : result) {
            const Point centre = point();
            const double size = uniform(0.3, 1.2), first = uniform(0, 2 * pi);
            const int corners = whole(4, 14);
            for (int i = 0; i < corners; ++i)
                area.outer.push_back(centre + size * uniform(0.45, 1) * unit(first + 2 * pi * i / corners));
        }
        return result;
    }
    CurvatureState state(const route::Ground& ground, bool curved) {
        for (;;) {
            const Point at = point();
            const double heading = uniform(-pi, pi), curvature = curved ? uniform(-1.4, 2) : 0;
            if (ground.clear(at)) return {{at, heading}, curvature};
        }
    }

  private:
    std::mt19937_64 engine_;
};

/// Whether moves of 0.3 m with the curvature going to one side's limit, to 0 or to the other's lead from
/// start to end, with a last curve from within 2 m: breadth first over cells of 0.2 m, 32 headings and the
/// curvature. From the end backwards first: most ends that cannot be left or come to are found by that.
inline bool exhaustive(const route::Ground& ground, const CurvatureState& from, const CurvatureState& to,
                       const CurveLimits& limits) {
    constexpr double cell = 0.2, step = 0.3, near = 2;
    constexpr int headings = 32, enough_to_leave = 20'000;
    struct State {
        Pose pose;
        int bend;
    };
    const double most = 1 / limits.radius;
    const auto search = [&](const CurvatureState& start, const CurvatureState* end) {
        std::set<std::tuple<long, long, long, int>> seen;
        std::queue<State> queue;
        const auto add = [&](const State& state) {
            const Point p = state.pose.at;
            const long turn = std::lround(state.pose.heading / (2 * pi) * headings);
            if (seen.emplace(std::lround(p.x / cell), std::lround(p.y / cell),
                             (turn % headings + headings) % headings, state.bend)
                    .second)
                queue.push(state);
        };
        add({start.pose, 0});
        for (int taken = 0; !queue.empty(); ++taken) {
            const State state = queue.front();
            queue.pop();
            if (!end && taken > enough_to_leave) return true;
            if (end && distance(state.pose.at, end->pose.at) < near &&
                ground.clear(continuous_curvature({state.pose, state.bend * most}, *end, limits)))
                return true;
            for (int bend = -1; bend <= 1; ++bend) {
                const double ramp = std::abs(bend - state.bend) * most / limits.sharpness;
                Curve move{state.pose, {}};
                if (ramp > 0)
                    move.pieces.push_back({ramp, state.bend * most, (bend - state.bend) * most / ramp});
                move.pieces.push_back({std::max(0.05, step - ramp), bend * most, 0});
                const Pose next = end_pose(move);
                if (contains(Box{{-1.5, -1.5}, {18.5, 18.5}}, next.at) && ground.clear(move))
                    add({next, bend});
            }
        }
        return false;
    };
    const CurvatureState back{{to.pose.at, to.pose.heading + pi}, -to.curvature};
    return search(from, nullptr) && search(back, nullptr) && search(from, &to);
}

}  // namespace strandline::testing
