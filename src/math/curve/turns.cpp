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

Spiral::Spiral(double slope, double left, double right) : sharpness(slope) {
    // Terms until the next is below rounding for every curvature up to 1.
    const double highest = std::min(1 / (2 * slope), series_heading), q = highest * highest;
    double power = 1;
    for (terms_ = 1; terms_ < terms && power * series[2 * terms_] * (terms_ % 2 == 0 ? 1 : -1) > 1e-18;
         ++terms_)
        power *= q;
    const auto limit = [&](double k) { return Limit{k, at(k), heading(k), unit(-heading(k))}; };
    left_ = limit(left);
    right_ = limit(right);
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

Pose Spiral::rise(double begin, double side) const {
    const double h = heading(begin);
    return {rotated(unit(-h), limit(side).at - at(begin)), limit(side).heading - h};
}

Turn::Turn(const Spiral& spiral, double begin)
    : natural(begin * std::abs(begin) / (2 * spiral.sharpness)),
      spiral_(&spiral),
      begin_(begin),
      begin_heading_(spiral.heading(begin)),
      begin_at_(spiral.at(begin)),
      back_(unit(-begin_heading_)) {
    const auto side = [&](double sign) {
        const Spiral::Limit& limit = spiral.limit(sign);
        return Side{&limit, 2 * limit.heading - begin_heading_, unit(limit.heading - begin_heading_)};
    };
    left_ = side(1);
    right_ = side(-1);
}

Turn::Shape Turn::shape(double angle) const {
    const double sign = angle >= natural ? 1 : -1, turned = sign * angle;
    const Side& side = sign > 0 ? left_ : right_;
    if (turned >= side.full_angle) return {side, sign, side.limit->curvature, turned - side.full_angle};
    return {side, sign, std::sqrt(std::max(0.0, spiral_->sharpness * turned + begin_ * begin_ / 2)), 0};
}

Turn::End Turn::end(double angle) const {
    const auto [side, sign, peak, stay] = shape(angle);
    const double turned = sign * angle, most = side.limit->curvature;
    const Point top = peak == most ? side.limit->at : spiral_->at(peak);
    const Point ahead = unit(turned);
    Point at = rotated(back_, top - sign * begin_at_) + rotated(ahead, {top.x, -top.y});
    if (stay > 0) {
        const Point leave = rotated(side.limit->back, ahead);
        at = at + (1 / most) * Point{leave.y - side.enter.y, side.enter.x - leave.x};
    }
    return {{at.x, sign * at.y}, (2 * peak - sign * begin_) / spiral_->sharpness + stay / most};
}

void Turn::append(std::vector<Clothoid>& pieces, double angle) const {
    const auto [side, sign, peak, stay] = shape(angle);
    const double slope = sign * spiral_->sharpness, up = (peak - sign * begin_) / spiral_->sharpness;
    if (up > 0) pieces.push_back({up, begin_, slope});
    if (stay > 0) pieces.push_back({stay / peak, sign * peak, 0});
    if (peak > 0) pieces.push_back({peak / spiral_->sharpness, sign * peak, -slope});
}

}  // namespace strandline::turns
