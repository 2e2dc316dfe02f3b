#include "path/order/shape.hpp"

#include <algorithm>
#include <utility>

namespace strandline::order {

std::optional<connect::Connection> shaped(const connect::Connection& plain, int a, int b, const Job& job,
                                          const connect::Options& options,
                                          std::vector<std::string>& unshaped) {
    std::optional<connect::Connection> found;
    for (std::size_t i = 0; i < job.shapes.size(); ++i) {
        const Shape& shape = job.shapes[i];
        const bool back = shape.a == b && shape.b == a;
        if (a == b || !(back || (shape.a == a && shape.b == b))) continue;
        std::vector<Pose> poses = shape.through;
        if (back) std::ranges::reverse(poses);
        if (back)
            for (Pose& pose : poses) pose.heading += pi;
        auto led = connect::led_through(plain, poses, options);
        unshaped[i] = led ? "" : sentence(led.error());
        if (led) found = std::move(*led);
    }
    return found;
}

}  // namespace strandline::order
