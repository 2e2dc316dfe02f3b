#pragma once
// What docs/svg.md promises of every document, for the suite and the fuzzer.
#include <cmath>
#include <set>
#include <string>

#include "input/svg/svg.hpp"

namespace strandline::svg {

inline bool sound(const std::vector<Path>& paths) {
    for (const auto& path : paths) {
        const auto box = bounds(path);
        if (path.segments.empty() || !is_finite(box.low) || !is_finite(box.high)) return false;
        if (path.closed && end_of(path) != path.start) return false;
    }
    return !paths.empty();
}

inline bool keeps_contract(const Document& document) {
    std::set<std::string> ids;
    for (const auto& shape : document.shapes) {
        if (!shape.fill && !shape.stroke) return false;
        if (!std::isfinite(shape.stroke_width) || !sound(shape.subpaths)) return false;
        if (shape.lines && (!shape.stroke || !shape.fill || !sound(*shape.lines))) return false;
        if (shape.id.empty() || !ids.insert(shape.id).second) return false;
        if (shape.layer_index >= static_cast<int>(document.layers.size())) return false;
    }
    for (std::size_t i = 0; i < document.layers.size(); ++i)
        if (document.layers[i].parent >= static_cast<int>(i)) return false;
    return true;
}

}  // namespace strandline::svg
