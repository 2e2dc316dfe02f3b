// QGroundControl's .plan: JSON (QGroundControl developer guide, Plan File Format). Home is not an item.
#include "base/text/text.hpp"
#include "result/exports/mission.hpp"

namespace strandline::exports {
namespace {

constexpr int ardupilot = 3, ground_rover = 10;  // MAV_AUTOPILOT, MAV_TYPE
constexpr int relative_to_home = 1;              // QGroundControl's altitude mode

void add_place(Text& text, Geographic at) {
    add_fixed(text, at.latitude, degree_decimals);
    add(text, ", ");
    add_fixed(text, at.longitude, degree_decimals);
}

void add_item(Text& text, const Item& item, std::size_t number) {
    add(text, "   {\"type\": \"SimpleItem\", \"autoContinue\": true, ");
    if (item.at) {
        add(text, "\"AMSLAltAboveTerrain\": null, \"Altitude\": 0, \"AltitudeMode\": ");
        add_number(text, static_cast<long long>(relative_to_home));
        add(text, ", ");
    }
    add(text, "\"command\": ");
    add_number(text, static_cast<long long>(item.command));
    add(text, ", \"doJumpId\": ");
    add_number(text, static_cast<long long>(number));
    add(text, ", \"frame\": ");
    add_number(text, static_cast<long long>(item.frame()));
    add(text, ", \"params\": [");
    for (std::size_t k = 0; k < item.parameters.size(); ++k) {
        if (k == 3 && item.at)
            add(text, "null");  // the heading at a waypoint: as it comes
        else
            add_number(text, item.parameters[k]);
        add(text, ", ");
    }
    if (item.at)
        add_place(text, *item.at);
    else
        add(text, "0, 0");
    add(text, ", 0]}");
}

void add_fence(Text& text, const Site& site, const Polygon& outline, bool inclusion, bool first) {
    add(text, first ? "\n" : ",\n");
    add(text,
        inclusion ? "   {\"inclusion\": true, \"polygon\": [" : "   {\"inclusion\": false, \"polygon\": [");
    for (std::size_t k = 0; k < outline.size(); ++k) {
        add(text, k > 0 ? ", [" : "[");
        add_place(text, to_geographic(site, outline[k]));
        add(text, "]");
    }
    add(text, "], \"version\": 1}");
}

/// A border that somebody drew, and every keep-out; fences have no holes.
void add_fences(Text& text, const Plan& plan, const Site& site) {
    const DriveArea area = drive_area_of(plan);
    bool first = true;
    if (plan.drawing.border || !plan.options.field.border.empty()) {
        add_fence(text, site, area.border.outer, true, first);
        first = false;
        for (const Polygon& hole : area.border.holes) add_fence(text, site, hole, false, false);
    }
    for (const Region& keep_out : area.keep_out) {
        add_fence(text, site, keep_out.outer, false, first);
        first = false;
    }
}

}  // namespace

Outcome<Written> qgc_plan(const Plan& plan) {
    auto mission = mission_of(plan);
    if (!mission) return tl::unexpected(mission.error());
    Text text = "{\n \"fileType\": \"Plan\",\n \"geoFence\": {\"circles\": [], \"polygons\": [";
    add_fences(text, plan, mission->site);
    add(text, "], \"version\": 2},\n \"groundStation\": \"QGroundControl\",\n \"mission\": {\n");
    add(text, "  \"cruiseSpeed\": ");
    add_number(text, plan.robot.travel_speed);
    add(text, ", \"hoverSpeed\": ");
    add_number(text, plan.robot.travel_speed);
    add(text, ", \"firmwareType\": ");
    add_number(text, static_cast<long long>(ardupilot));
    add(text, ", \"vehicleType\": ");
    add_number(text, static_cast<long long>(ground_rover));
    add(text, ", \"globalPlanAltitudeMode\": ");
    add_number(text, static_cast<long long>(relative_to_home));
    add(text, ",\n  \"plannedHomePosition\": [");
    add_place(text, mission->home);
    add(text, ", 0],\n  \"items\": [\n");
    for (std::size_t k = 0; k < mission->items.size(); ++k) {
        add_item(text, mission->items[k], k + 1);
        add(text, k + 1 < mission->items.size() ? ",\n" : "\n");
    }
    add(text, "  ],\n  \"version\": 2\n },\n \"rallyPoints\": {\"points\": [], \"version\": 2},\n");
    add(text, " \"version\": 1\n}\n");
    return Written{{{".plan", std::move(text)}}, std::move(mission->warnings)};
}

}  // namespace strandline::exports
