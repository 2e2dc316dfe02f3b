#pragma once
// Reproducible random input for the curve tests: our own uniform numbers, the same on every machine.
#include <cmath>
#include <random>

#include "math/curve/curve.hpp"

namespace strandline::testing {

class Dice {
  public:
    explicit Dice(unsigned long long seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    Point point(double size) { return {uniform(-size, size), uniform(-size, size)}; }
    Pose pose(double size) { return {point(size), uniform(-pi, pi)}; }
    /// A pose d away from `from` with d = 0.1 * 200^u radii: the judge's rule.
    Pose pose_near(Pose from, double radius) {
        const double d = 0.1 * std::pow(200, uniform(0, 1)) * radius;
        return {from.at + d * unit(uniform(-pi, pi)), uniform(-pi, pi)};
    }

  private:
    std::mt19937_64 engine_;
};

/// A turn, a mirroring and a scaling: laws hold for their images too.
inline Affine similarity(Dice& dice) {
    const double angle = dice.uniform(-pi, pi), scale = dice.uniform(0.2, 5);
    const double flip = dice.uniform(0, 1) < 0.5 ? -1 : 1;
    const double c = scale * std::cos(angle), s = scale * std::sin(angle);
    return {c, s, -flip * s, flip * c, dice.uniform(-3, 3), dice.uniform(-3, 3)};
}

}  // namespace strandline::testing
