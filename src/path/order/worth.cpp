#include "path/order/worth.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::order {
namespace {

/// Of max(1, |x|) from 0 to x.
double integral(double x) {
    const double a = std::abs(x);
    return std::copysign(a <= 1 ? a : (a * a + 1) / 2, x);
}

}  // namespace

double worth(const Curve& curve, const Options& options) {
    const double stood = options.connect.back_up ? options.connect.stand_cost * stands(curve) : 0;
    if (options.slow_bends <= 0) return length(curve) + stood;
    double sum = stood;
    for (const Clothoid& piece : curve.pieces) {
        const double from = options.slow_bends * piece.curvature,
                     to = options.slow_bends * piece.end_curvature();
        // the mean over the piece, along which curvature is linear
        constexpr double same = 1e-9;
        const double mean = std::abs(to - from) < same ? std::max(1.0, std::abs(from))
                                                       : (integral(to) - integral(from)) / (to - from);
        sum += mean * std::abs(piece.length);
    }
    return sum;
}

}  // namespace strandline::order
