#pragma once
// From the arguments of plan to plans: what one drawing and a batch of them share.
#include <string>

#include "arguments.hpp"
#include "input/svg/svg.hpp"

namespace strandline::cli {

/// What a call of plan asks for every drawing, found to be sound before the first one is opened.
struct Asked {
    Wishes wishes;
    Robot robot;
    double most_time = 0;  ///< s that a drive may take; 0: as long as it takes
};
/// Error: the call is at fault.
Outcome<Asked> asked_of(const PlanArguments& arguments);

/// The plan that is asked for, signed by this program; what the wishes took for granted comes first in its
/// warnings. `progress`: the user's, without a limit of time: that of tour.time_limit is set here, anew for
/// each size that --max-time tries. Errors as make_plan, and --max-time that cannot be kept, or was stopped
/// before a size that fits was found; stopped later, the plan is the largest so far, not reproducible, and
/// warns.
Outcome<Plan> planned(const svg::Document& document, const std::string& title, const Asked& asked,
                      const Progress& progress);

/// The error of planning the drawing `title` from the file `input`, with the file in front of the place in
/// it.
Error in_file(Error error, const std::string& title, const std::string& input);

}  // namespace strandline::cli
