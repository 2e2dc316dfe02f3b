#pragma once
// A plan as the editor takes it: parts with a tag each, so that only what changed is sent again.
#include <memory>
#include <string>
#include <vector>

#include "plan/model/model.hpp"
#include "result/check/check.hpp"
#include "sample_row.hpp"

namespace strandline::serve {

/// With a parameter httplib does not compress it: on one machine that costs more than it saves.
inline constexpr const char* json_type = "application/json; charset=utf-8";

struct Part {
    std::string bytes, type;
    std::string tag;  ///< of the bytes: the same again where nothing changed
};
Part part_of(std::string bytes, std::string type);

/// What is to be drawn: canvas, elements as points in metres, their nodes. Elements that are as in the plan
/// before are not written again.
class DrawingMaker {
  public:
    Part part(const std::shared_ptr<const Plan>& plan);

  private:
    std::shared_ptr<const Plan> last_;
    std::vector<std::string> texts_;  ///< of its elements
};
/// How it is driven: strokes in order, connections, runs of samples, stops, figures, what falls short.
Part drive_part(const Plan& plan, const SampleRow& samples);
/// What check found.
Part report_part(const check::Report& report);

}  // namespace strandline::serve
