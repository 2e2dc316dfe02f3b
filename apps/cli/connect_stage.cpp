#include "connect_stage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "path/route/route.hpp"

namespace strandline::cli {

Outcome<connect::Style> style_of(const std::string& name) {
    const auto& names = connect::style_names();
    const auto it = std::ranges::find(names, name);
    if (it != names.end()) return static_cast<connect::Style>(it - names.begin());
    return fail("--style", fmt::format("\"{}\" is not a style", name),
                fmt::format("choose one of: {}", fmt::join(names, ", ")));
}

Led led_round(const stages::Pair& pair, connect::Connection direct) {
    if (!stages::hits_obstacles(pair, direct.curve)) return {std::move(direct)};
    if (!pair.through.empty())
        return {
            std::move(direct), false,
            "the curve comes nearer to an obstacle than the clearance; poses to be met are not led round"};
    const double right = pair.limits.right_radius;
    route::Ground ground({.clearance = pair.clearance,
                          .radius = right > 0 ? std::min(right, pair.limits.radius) : pair.limits.radius});
    for (const Polygon& ring : pair.obstacles) ground.add(Region{ring, {}});
    route::Way way = route::way(ground, pair.from, pair.to, {.limits = pair.limits});
    Led led{{0, 0, std::move(way.curve), std::move(direct.broken)}, true};
    if (way.blemish > 0 || stages::hits_obstacles(pair, led.connection.curve))
        led.failure = fmt::format(
            "no way round the obstacles was found; this one is nearer to them than the clearance for {:.2f} "
            "m",
            way.blemish);
    return led;
}

}  // namespace strandline::cli
