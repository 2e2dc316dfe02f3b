#pragma once
// Strokes that all but touch are driven as one.
#include "path/order/order.hpp"

namespace strandline::order {

/// A stroke as it will be driven: its rake path in driving direction.
struct Planned {
    int stroke = -1;  ///< index in Ordered::strokes
    std::vector<Curve> rake_path;
};
/// Drives strokes with the same middle of their pins whose ends lie within a small gap as one rake path,
/// straight across the gaps with the rake up, and gives the legs back to their strokes. One stroke alone is
/// simply driven.
drive::Drive drive_chain(const std::vector<Planned>& chain, const std::vector<Stroke>& strokes,
                         const Robot& robot, const drive::Options& options);

}  // namespace strandline::order
