#include "path/order/shape.hpp"

#include <algorithm>
#include <utility>

namespace strandline::order {
namespace {

/// Metres: places that edits name are rounded.
constexpr double same_place = 1e-3;

enum class Leads { not_it, on, back };

Leads leads(const Shape& shape, const Between& ends, const Job& job) {
    const auto element = [&](int group) { return job.groups[static_cast<std::size_t>(group)].work.element; };
    if (shape.hop) {
        const bool here = element(shape.a) == element(ends.a) && element(shape.a) == element(ends.b) &&
                          distance(shape.hop->first, ends.from) < same_place &&
                          distance(shape.hop->second, ends.to) < same_place;
        return here ? Leads::on : Leads::not_it;
    }
    if (ends.a == ends.b) return Leads::not_it;
    if (shape.a == ends.a && shape.b == ends.b) return Leads::on;
    return shape.a == ends.b && shape.b == ends.a ? Leads::back : Leads::not_it;
}

}  // namespace

std::optional<connect::Connection> shaped(const connect::Connection& plain, const Between& ends,
                                          const Job& job, const connect::Options& options,
                                          std::vector<std::string>& unshaped) {
    std::optional<connect::Connection> found;
    for (std::size_t i = 0; i < job.shapes.size(); ++i) {
        const Shape& shape = job.shapes[i];
        const Leads way = leads(shape, ends, job);
        if (way == Leads::not_it) continue;
        std::vector<Pose> poses = shape.through;
        if (way == Leads::back) std::ranges::reverse(poses);
        if (way == Leads::back)
            for (Pose& pose : poses) pose.heading += pi;
        auto led = connect::led_through(plain, poses, options);
        unshaped[i] = led ? "" : sentence(led.error());
        if (led) found = std::move(*led);
    }
    return found;
}

}  // namespace strandline::order
