#include "machine/follow/nodes.hpp"

#include <algorithm>
#include <cmath>

namespace strandline {

std::vector<RakeNode> nodes_of(const std::vector<Curve>& rake_path, double step) {
    std::vector<RakeNode> nodes;
    double s = 0, heading_before = 0;
    for (const Curve& curve : rake_path) {
        Pose at = curve.start;
        at.heading = nodes.empty() ? at.heading : heading_before + wrap_angle(at.heading - heading_before);
        for (const Clothoid& piece : curve.pieces) {
            if (piece.length <= rounding) continue;
            const double steps = std::max(1.0, std::ceil(piece.length / step - 1e-9));
            const double h = piece.length / steps;
            for (double i = 0; i <= steps; ++i) {
                const double local = i < steps ? i * h : piece.length;
                nodes.push_back({s + local, advanced(at, piece, local),
                                 piece.curvature + piece.sharpness * local, i < steps ? h : 0,
                                 piece.curvature + piece.sharpness * std::min(local + h, piece.length)});
            }
            at = advanced(at, piece, piece.length);
            s += piece.length;
            heading_before = at.heading;
        }
    }
    return nodes;
}

double curvature_at(const RakeNode& node, double local) {
    return node.step > 0 ? node.curvature + (node.next_curvature - node.curvature) * local / node.step
                         : node.curvature;
}

Pose rake_at(const RakeNode& node, double local) {
    if (node.step <= 0) return node.rake;
    return advanced(node.rake,
                    {node.step, node.curvature, (node.next_curvature - node.curvature) / node.step}, local);
}

}  // namespace strandline
