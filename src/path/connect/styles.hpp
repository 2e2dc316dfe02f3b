#pragma once
// Private to the room: the styles' own curves.
#include <optional>

#include "path/connect/connect.hpp"

namespace strandline::connect {

/// At most (1 + extra) times as long as `bounded`, with the least bending and sharpness that a search over
/// gentler limits finds; `bounded` itself where none is gentler.
Curve fair(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits, Curve bounded,
           double extra);

/// Splines as they are, whatever limits they break; nullopt where there is none.
std::optional<Curve> spiro(const CurvatureState& from, const CurvatureState& to, const CurveLimits& limits);
std::optional<Curve> bezier(const CurvatureState& from, const CurvatureState& to);

/// Which limit the curve breaks first, in words; empty: none.
std::string broken_limit(const Curve& curve, const CurvatureState& from, const CurvatureState& to,
                         const CurveLimits& limits);

}  // namespace strandline::connect
