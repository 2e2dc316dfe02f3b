#include "leading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plan/pipeline/pipeline.hpp"
#include "result/formats/formats.hpp"

namespace strandline::serve {
namespace {

using Json = nlohmann::ordered_json;

// Points of the answer: enough for a smooth line on a screen.
constexpr double most_points = 300;

struct Wish {
    long long plan = 0;
    int connection = 0;
    std::vector<Pose> through;
};

Outcome<Wish> wish_in(std::string_view body) {
    const Json json = Json::parse(body, nullptr, false);
    if (json.is_discarded() || !json.is_object())
        return fail("body", "is no JSON object", "send a JSON object");
    const auto whole = [&](const char* key) {
        return json.contains(key) && json[key].is_number_integer() ? json[key].get<long long>() : -1;
    };
    Wish wish{whole("plan"), static_cast<int>(std::clamp(whole("connection"), -1LL, 1LL << 30)), {}};
    if (wish.plan < 0 || wish.connection < 0)
        return fail("body", "plan and connection are whole numbers", "see /openapi.json");
    const auto through = json.find("through");
    if (through == json.end() || !through->is_array())
        return fail("body/through", "is no list", "send poses: [[x, y, heading], ...]");
    if (through->size() > ThroughEdit::most_poses)
        return fail("body/through", fmt::format("holds more than {} poses", ThroughEdit::most_poses),
                    "leave some out");
    for (const Json& row : *through) {
        const bool numbers = row.is_array() && row.size() == 3 &&
                             std::ranges::all_of(row, [](const Json& n) { return n.is_number(); });
        if (!numbers) return fail("body/through", "holds no poses", "send [[x, y, heading], ...]");
        wish.through.push_back({{row[0].get<double>(), row[1].get<double>()}, row[2].get<double>()});
    }
    return wish;
}

}  // namespace

Reply leading_reply(const Workspace& workspace, std::string_view body) {
    const auto wish = wish_in(body);
    if (!wish) return refusal(400, wish.error());
    const auto planned = workspace.planned();
    if (!planned || planned->revision != wish->plan)
        return refusal(409, {"plan", "is another by now", "take over the new one, then ask again"});
    const auto led = led_connection(*planned->plan, wish->connection, wish->through);
    if (!led) return refusal(422, led.error());
    Json points = Json::array();
    const double whole = length(led->curve);
    for (const CurvePoint& point : sampled(led->curve, std::max(whole / most_points, 1e-6))) {
        points.push_back(point.pose.at.x);
        points.push_back(point.pose.at.y);
    }
    const Json json{{"points", std::move(points)}, {"length", whole}, {"loops", led->loops}};
    return json_reply(200, json.dump());
}

}  // namespace strandline::serve
