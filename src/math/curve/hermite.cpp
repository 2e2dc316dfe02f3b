// One clothoid between two poses. Notation of Bertolazzi and Frego 2015: phi0, phi1 the headings against the
// chord, delta = phi1 - phi0; on tau in 0..1 the heading is A tau^2 + (delta - A) tau + phi0; g(A) = integral
// of its sine.
#include <algorithm>
#include <cmath>

#include "math/curve/curve.hpp"
#include "math/curve/quadrature.hpp"

namespace strandline {
namespace {

struct Integrals {
    double sine = 0, cosine = 0, slope = 0;  ///< slope = dg/dA
};

Integrals integrals(double a, double delta, double phi0) {
    Integrals sum;
    // The heading's slope is at most |delta| + |A| anywhere: 1.5 rad a panel keeps ten nodes exact to
    // rounding.
    const double panels = std::clamp(std::ceil((std::abs(a) + std::abs(delta)) / 1.5), 1.0, 100.0);
    for (double i = 0; i < panels; ++i)
        quadrature::panel(i / panels, (i + 1) / panels, [&](double t, double weight) {
            const double angle = (a * t + delta - a) * t + phi0, c = std::cos(angle);
            sum.sine += weight * std::sin(angle);
            sum.cosine += weight * c;
            sum.slope += weight * c * t * (t - 1);
        });
    return sum;
}

/// Their fitted first guess (section 3.3): Newton then takes two or three steps.
double first_guess(double phi0, double phi1) {
    const double x = phi0 / pi, y = phi1 / pi, xy = x * y, squares = x * x + y * y;
    return (phi0 + phi1) *
           (2.989696028701907 + xy * (0.716228953608281 + xy * -0.458969738821509) +
            (-0.502821153340377 + 0.261062141752652 * xy) * squares - 0.045854475238709 * squares * squares);
}

constexpr int most_steps = 20;
constexpr double accuracy = 1e-13;

}  // namespace

Curve hermite_clothoid(Pose from, Pose to) {
    const Point chord = to.at - from.at;
    const double span = length(chord), direction = heading(chord);
    const double phi0 = wrap_angle(from.heading - direction), phi1 = wrap_angle(to.heading - direction);
    const double delta = phi1 - phi0;
    double a = first_guess(phi0, phi1);
    Integrals at = integrals(a, delta, phi0);
    for (int i = 0; i < most_steps && std::abs(at.sine) > accuracy && at.slope != 0; ++i) {
        a -= at.sine / at.slope;
        at = integrals(a, delta, phi0);
    }
    const double whole = span / at.cosine;
    return {from, {{whole, (delta - a) / whole, 2 * a / (whole * whole)}}};
}

}  // namespace strandline
