// "QGC WPL 110" (mavlink.io, File Formats): fields between tabs, item 0 is home.
#include "base/text/text.hpp"
#include "result/exports/mission.hpp"

namespace strandline::exports {

Outcome<Written> wpl(const Plan& plan) {
    auto mission = mission_of(plan);
    if (!mission) return tl::unexpected(mission.error());
    constexpr int frame_global = 0;
    Text text = "QGC WPL 110\n";
    const auto line = [&](std::size_t index, int frame, const Item& item) {
        const auto field = [&](long long value) {
            add_number(text, value);
            add(text, "\t");
        };
        field(static_cast<long long>(index));
        field(index == 0 ? 1 : 0);
        field(frame);
        field(static_cast<int>(item.command));
        for (const double parameter : item.parameters) {
            add_number(text, parameter);
            add(text, "\t");
        }
        const Geographic at = item.at.value_or(Geographic{});
        add_fixed(text, at.latitude, item.at ? degree_decimals : 0);
        add(text, "\t");
        add_fixed(text, at.longitude, item.at ? degree_decimals : 0);
        add(text, "\t0\t1\n");  // at home's height; on to the next by itself
    };
    line(0, frame_global, {Command::waypoint, {}, mission->home});
    for (std::size_t k = 0; k < mission->items.size(); ++k)
        line(k + 1, mission->items[k].frame(), mission->items[k]);
    return Written{{{".waypoints", std::move(text)}}, std::move(mission->warnings)};
}

}  // namespace strandline::exports
