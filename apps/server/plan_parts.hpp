#pragma once
// A plan as the editor takes it: parts with a tag each, so that only what changed is sent again.
#include <memory>
#include <string>

#include "plan/model/model.hpp"
#include "result/check/check.hpp"

namespace strandline::serve {

/// With a parameter httplib does not compress it: on one machine that costs more than it saves.
inline constexpr const char* json_type = "application/json; charset=utf-8";

struct Part {
    std::string bytes, type;
    std::string tag;  ///< of the bytes: the same again where nothing changed
};
Part part_of(std::string bytes, std::string type);

/// What is to be drawn: canvas, elements as points in metres, their nodes.
Part drawing_part(const Plan& plan);
/// How it is driven: strokes in order, connections, runs of samples, stops, figures, what falls short.
Part drive_part(const Plan& plan);
/// The trajectory, little-endian: "SLS1", count n as uint32; then columns of n values each: float32 t, x, y,
/// heading, rake x, rake y; uint32 mask; int32 stroke; uint8 motion (draw, lead, loop, connect, pivot).
Part samples_part(const Plan& plan);
/// What check found.
Part report_part(const check::Report& report);

}  // namespace strandline::serve
