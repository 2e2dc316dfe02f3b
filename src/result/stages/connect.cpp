// Pairs of poses, one JSON object a line, and the curves between them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

using Json = nlohmann::ordered_json;

/// Steps of the samples in radii, and samples at least: what the format asks for.
constexpr double sample_step = 0.01;
constexpr int fewest_samples = 9;
/// Whoever reads a curvature off three samples should be within this of the truth at the ends (1/R).
constexpr double end_blur = 0.025;
/// Few of that many samples lie at a bend of the curvature; finer than this (radii) nine decimals are too
/// few.
constexpr double many_samples = 256, finest_step = 0.0015;
/// Metres: steps below sqrt(this R) read the ninth decimal's rounding as curvature (0.1 % of 1/R).
constexpr double blurring_digits = 1e-6;
/// Farther apart than this (radii) a curve would have more than ten million samples.
constexpr double farthest = 1e5;
/// Beyond this a coordinate has no nine decimals left.
constexpr double largest_coordinate = 1e7;
/// Range of sigma R^2. Below, reaching the least radius takes thousands of radii of driving.
constexpr double least_sharpness = 1e-3, most_sharpness = 1e9;
/// A curvature this far over 1/R is rounding of 1/R (relative).
constexpr double curvature_slack = 1e-6;

struct Reader {
    const Json& object;
    std::string place;

    Outcome<double> number(const char* key, double otherwise) const {
        const auto it = object.find(key);
        if (it == object.end() || it->is_null()) return otherwise;
        if (!it->is_number() || !std::isfinite(it->get<double>()))
            return fail(place, fmt::format("\"{}\" is not a number", key), "write a finite number");
        return it->get<double>();
    }

    Outcome<Pose> pose(const char* key) const {
        const auto it = object.find(key);
        const auto wrong = [&](std::string_view why) {
            return fail(place, fmt::format("\"{}\" {}", key, why),
                        fmt::format("write \"{}\": [x, y, theta]", key));
        };
        if (it == object.end()) return wrong("is missing");
        if (!it->is_array() || it->size() != 3) return wrong("is not three numbers");
        double v[3];
        for (std::size_t i = 0; i < 3; ++i) {
            if (!(*it)[i].is_number()) return wrong("is not three numbers");
            v[i] = (*it)[i].get<double>();
            if (!(std::abs(v[i]) <= largest_coordinate)) return wrong("is not within 1e7");
        }
        return Pose{{v[0], v[1]}, v[2]};
    }

    Outcome<std::vector<Pose>> through() const {
        std::vector<Pose> poses;
        const auto it = object.find("through");
        if (it == object.end() || it->is_null()) return poses;
        if (!it->is_array()) return fail(place, "\"through\" is not a list", "write [[x, y, theta], ...]");
        for (const Json& entry : *it) {
            const auto pose = Reader{Json{{"through", entry}}, place}.pose("through");
            if (!pose) return tl::unexpected(pose.error());
            poses.push_back(*pose);
        }
        return poses;
    }

    Outcome<std::vector<Polygon>> obstacles() const {
        std::vector<Polygon> rings;
        const auto it = object.find("obstacles");
        if (it == object.end() || it->is_null()) return rings;
        const auto wrong = [&] {
            return fail(place, "\"obstacles\" is not a list of rings",
                        "write [[[x, y], ...], ...], three points or more a ring");
        };
        if (!it->is_array()) return wrong();
        for (const Json& ring : *it) {
            if (!ring.is_array() || ring.size() < 3) return wrong();
            Polygon polygon;
            for (const Json& p : ring) {
                if (!p.is_array() || p.size() != 2 || !p[0].is_number() || !p[1].is_number()) return wrong();
                polygon.push_back({p[0].get<double>(), p[1].get<double>()});
                if (!is_finite(polygon.back())) return wrong();
            }
            rings.push_back(std::move(polygon));
        }
        return rings;
    }
};

Outcome<Pair> pair_of(const Reader& in, const PairDefaults& defaults) {
    const auto start = in.pose("start"), end = in.pose("end");
    if (!start) return tl::unexpected(start.error());
    if (!end) return tl::unexpected(end.error());
    const auto radius = in.number("R", defaults.radius);
    if (!radius) return tl::unexpected(radius.error());
    if (!(*radius > 0)) return fail(in.place, "\"R\" is not above 0", "write a radius in metres");
    const double r = *radius;
    const auto sharpness = in.number("sigma", defaults.sharpness.value_or(2.5 / (r * r)));
    if (!sharpness) return tl::unexpected(sharpness.error());
    if (!(*sharpness * r * r >= least_sharpness && *sharpness * r * r <= most_sharpness))
        return fail(
            in.place,
            fmt::format("\"sigma\" is {} and R {}: sigma R^2 is not within 0.001 to 1e9", *sharpness, r),
            "write a sharpness such as 2.5 / R^2");
    if (distance(start->at, end->at) > farthest * r)
        return fail(in.place, "start and end are more than 100,000 R apart", "check the units");
    const auto right = in.number("R_right", r);
    if (!right) return tl::unexpected(right.error());
    if (!(*right > 0)) return fail(in.place, "\"R_right\" is not above 0", "write a radius in metres");
    const auto k0 = in.number("kappa0", 0), k1 = in.number("kappa1", 0),
               clearance = in.number("clearance", 0);
    for (const auto* k : {&k0, &k1, &clearance})
        if (!*k) return tl::unexpected(k->error());
    for (const auto& [key, k] : {std::pair{"kappa0", *k0}, std::pair{"kappa1", *k1}})
        if (const double least = k > 0 ? r : *right; std::abs(k) * least > 1 + curvature_slack)
            return fail(in.place,
                        fmt::format("\"{}\" is {}, tighter than 1/{} = {}", key, k,
                                    k < 0 && *right != r ? "R_right" : "R", 1 / least),
                        fmt::format("ask for less curvature or a smaller {}",
                                    k < 0 && *right != r ? "R_right" : "R"));
    if (*clearance < 0) return fail(in.place, "\"clearance\" is below 0", "write metres, 0 or more");
    auto obstacles = in.obstacles();
    if (!obstacles) return tl::unexpected(obstacles.error());
    auto through = in.through();
    if (!through) return tl::unexpected(through.error());
    const auto clamped = [&](double k) { return std::clamp(k, -1 / *right, 1 / r); };
    return Pair{{*start, clamped(*k0)},
                {*end, clamped(*k1)},
                std::move(*through),
                {r, *sharpness, *right == r ? 0 : *right},
                std::move(*obstacles),
                *clearance,
                {}};
}

/// 0.01 R; finer where the curvature is sharp and bends within three steps of an end or many times in a short
/// curve: whoever reads curvatures off neighbouring samples would see them blurred.
double step_for(const Curve& curve, const CurveLimits& limits) {
    const double step = sample_step * limits.radius, whole = length(curve);
    const double finest = std::max(finest_step * limits.radius, std::sqrt(blurring_digits * limits.radius));
    const double sharp_step = std::max(finest, end_blur / (limits.radius * limits.sharpness));
    if (sharp_step >= step) return step;
    double s = 0;
    for (const Clothoid& piece : curve.pieces) {
        s += piece.length;
        if (s < whole && std::min(s, whole - s) < 3 * step) return sharp_step;
    }
    return std::clamp(whole / many_samples, std::min(step, finest), step);
}

}  // namespace

Outcome<Pair> read_pair(std::string_view line, int number, const PairDefaults& defaults) {
    const std::string place = fmt::format("line {}", number);
    const Json object = Json::parse(line, nullptr, false);
    if (!object.is_object())
        return fail(place, "is not a JSON object",
                    "write {\"start\": [x, y, theta], \"end\": [x, y, theta]} on one line");
    auto pair = pair_of({object, place}, defaults);
    if (!pair) return pair;
    pair->source = line;
    // what write_curve wrote, read again, is no surprise
    constexpr std::array<std::string_view, 15> known{
        "start", "end",       "R",         "R_right", "sigma", "kappa0", "kappa1",  "through",
        "id",    "obstacles", "clearance", "samples", "ok",    "reason", "fallback"};
    for (const auto& item : object.items())
        if (std::ranges::find(known, item.key()) == known.end()) pair->unknown.push_back(item.key());
    return pair;
}

std::string write_curve(const Pair& pair, const connect::Connection& connection,
                        const std::optional<std::string>& failure) {
    Json object = Json::parse(pair.source, nullptr, false);
    for (const char* ours : {"samples", "ok", "reason", "fallback"}) object.erase(ours);
    object["R"] = pair.limits.radius;
    object["sigma"] = pair.limits.sharpness;
    if (!connection.broken.empty()) object["fallback"] = connection.broken;
    if (failure) {
        object["ok"] = false;
        object["reason"] = *failure;
    }
    std::string text = object.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.pop_back();
    text += ",\"samples\":[";
    std::vector<CurvePoint> points =
        sampled(connection.curve, step_for(connection.curve, pair.limits), fewest_samples);
    while (points.size() < fewest_samples) points.push_back(points.back());  // a turn on the spot alone
    text.reserve(text.size() + 32 * points.size());
    auto out = std::back_inserter(text);
    for (const CurvePoint& p : points) fmt::format_to(out, "[{:.9f},{:.9f}],", p.pose.at.x, p.pose.at.y);
    text.back() = ']';
    text += '}';
    return text;
}

bool hits_obstacles(const Pair& pair, const Curve& curve) {
    if (pair.obstacles.empty()) return false;
    const std::vector<CurvePoint> points = sampled(curve, sample_step * pair.limits.radius, fewest_samples);
    for (const Polygon& ring : pair.obstacles) {
        const Box near = grown(bounds(ring), pair.clearance);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point p = points[i].pose.at, before = points[i > 0 ? i - 1 : 0].pose.at;
            if (!overlaps(near, including(including(Box{}, p), before))) continue;
            if (contains(ring, p) || distance_to_outline(ring, p) < pair.clearance) return true;
            for (std::size_t k = 0, j = ring.size() - 1; k < ring.size(); j = k++)  // thinner than a step
                if (crossing(before, p, ring[j], ring[k])) return true;
        }
    }
    return false;
}

}  // namespace strandline::stages
