#include "controller.hpp"

#include <fmt/format.h>

#include "base/units/units.hpp"

namespace strandline::cli {

Outcome<tracking::Options> controller(const SimulateArguments& a, const Robot& robot) {
    tracking::Options options;
    options.localisation.noise = robot.fix_noise;
    options.seed = a.seed;
    options.lead_pins = !a.late_pins;
    tracking::Localisation& l = options.localisation;
    const auto put = [](double& field, const Outcome<double>& value) -> Outcome<void> {
        if (!value) return tl::unexpected(value.error());
        field = *value;
        return {};
    };
    Outcome<void> done;
    if (a.noise && !a.noise->empty()) done = put(l.noise, parse_length(*a.noise, "--noise"));
    if (done && !a.wander.empty()) done = put(l.wander, parse_length(a.wander, "--wander"));
    if (done && !a.delay.empty()) done = put(l.delay, parse_duration(a.delay, "--delay"));
    if (!done) return tl::unexpected(done.error());
    constexpr double most_delay = 2, most_error = 10;
    if (!(l.noise >= 0 && l.noise <= most_error && l.wander >= 0 && l.wander <= most_error))
        return fail("--noise, --wander", "are out of range", fmt::format("use 0 to {} m", most_error));
    if (!(l.delay >= 0 && l.delay <= most_delay))
        return fail("--delay", "is out of range", fmt::format("use 0 to {} s", most_delay));
    // Who says that places are known exactly means headings and wheels too.
    if (l.noise == 0) l.heading_noise = 0;
    if (l.wander == 0) l.slip = 0;
    return options;
}

}  // namespace strandline::cli
