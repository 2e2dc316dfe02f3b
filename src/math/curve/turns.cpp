#include "math/curve/turns.hpp"

#include <array>
#include <cmath>

namespace strandline::turns {
namespace {

/// Up to this heading the power series below reach rounding.
constexpr double series_heading = 2;
constexpr int terms = 13;

/// 1 / (n! (2 n + 1)) with alternating signs for the even (cosine) and odd (sine) n.
constexpr std::array<double, 2 * terms> coefficients() {
    std::array<double, 2 * terms> c{};
    double factorial = 1;
    for (int n = 0; n < 2 * terms; ++n) {
        if (n > 0) factorial *= n;
        const double sign = n / 2 % 2 == 0 ? 1 : -1;
        c[static_cast<std::size_t>(n)] = sign / (factorial * (2 * n + 1));
    }
    return c;
}
constexpr auto series = coefficients();

}  // namespace

Spiral::Spiral(double limit) : sharpness(limit), full_heading(1 / (2 * limit)) {
    // Terms until the next is below rounding for every curvature up to 1.
    const double q = std::min(full_heading, series_heading) * std::min(full_heading, series_heading);
    double power = 1;
    for (terms_ = 1; terms_ < terms && power * series[2 * terms_] * (terms_ % 2 == 0 ? 1 : -1) > 1e-18;
         ++terms_)
        power *= q;
    full = at(1);
    full_back = unit(-full_heading);
}

Point Spiral::at(double curvature) const {
    const double s = curvature / sharpness, h = heading(curvature);
    if (h > series_heading) {
        const Point p = advanced({}, {std::abs(s), 0, sharpness}, std::abs(s)).at;
        return s < 0 ? -p : p;
    }
    // Fresnel integrals as series in the heading (Abramowitz and Stegun 7.3.11 and 7.3.13).
    const double q = h * h;
    Point sum{};
    for (std::size_t n = terms_; n-- > 0;) sum = {sum.x * q + series[2 * n], sum.y * q + series[2 * n + 1]};
    return {s * sum.x, s * h * sum.y};
}

Pose Spiral::rise(double begin) const {
    const double h = heading(begin);
    return {rotated(unit(-h), full - at(begin)), full_heading - h};
}

Turn::Turn(const Spiral& spiral, double begin)
    : natural(begin * std::abs(begin) / (2 * spiral.sharpness)),
      spiral_(&spiral),
      begin_(begin),
      begin_heading_(spiral.heading(begin)),
      full_angle_((1 - begin * begin / 2) / spiral.sharpness),
      begin_at_(spiral.at(begin)),
      back_(unit(-begin_heading_)),
      enter_(unit(spiral.full_heading - begin_heading_)) {}

Turn::Shape Turn::shape(double angle) const {
    const double side = angle >= natural ? 1 : -1, turned = side * angle;
    if (turned >= full_angle_) return {side, 1, turned - full_angle_};
    return {side, std::sqrt(std::max(0.0, spiral_->sharpness * turned + begin_ * begin_ / 2)), 0};
}

Turn::End Turn::end(double angle) const {
    const auto [side, peak, stay] = shape(angle);
    const double turned = side * angle;
    const Point top = peak == 1 ? spiral_->full : spiral_->at(peak);
    const Point ahead = unit(turned);
    Point at = rotated(back_, top - side * begin_at_) + rotated(ahead, {top.x, -top.y});
    if (stay > 0) {
        const Point leave = rotated(spiral_->full_back, ahead);
        at = at + Point{leave.y - enter_.y, enter_.x - leave.x};
    }
    return {{at.x, side * at.y}, (2 * peak - side * begin_) / spiral_->sharpness + stay};
}

void Turn::append(std::vector<Clothoid>& pieces, double angle) const {
    const auto [side, peak, stay] = shape(angle);
    const double slope = side * spiral_->sharpness, up = (peak - side * begin_) / spiral_->sharpness;
    if (up > 0) pieces.push_back({up, begin_, slope});
    if (stay > 0) pieces.push_back({stay, side, 0});
    if (peak > 0) pieces.push_back({peak / spiral_->sharpness, side * peak, -slope});
}

}  // namespace strandline::turns
