#pragma once
// The table a person reads after planning.
#include <string>

#include "plan/model/model.hpp"
#include "result/check/check.hpp"
#include "result/formats/formats.hpp"
#include "result/legibility/legibility.hpp"

namespace strandline::cli {

/// Lines of text, each ended: scale, elements, lengths, time, what fell short.
std::string summary(const Plan& plan, const check::Report& report);
/// Lines: bare places as planned and as driven, finished sand met, and where the rake cannot follow its path;
/// not `all`: one that says how many of them warnings sum up.
std::string places(const Plan& plan, const check::Report& report, bool all);
/// A line for each reason that --strict ends with 3; empty: there is none.
std::string shortcomings(const Plan& plan, const check::Report& report);
/// The check's findings, a line each; "" when there are none.
std::string findings(const check::Report& report, bool all);

/// How true the sand is to the drawing, a line each, as `check` prints them too.
std::string fidelity_rows(const fidelity::Report& report);
/// Details finer than the rake, and on which canvas they would survive; "" where there are none. `all` lists
/// each.
std::string legibility_rows(const Drawing& drawing, const legibility::Report& report, bool all);
/// The table a person reads after simulating; `all` lists the places of flaws.
std::string simulated(const formats::Simulated& found, bool all);
/// "1.25 m"; below 10 cm, as on paper, "12.5 mm".
std::string length(double metres);
/// "1.25 m^2"; below 0.1 m^2 "12.5 cm^2".
std::string square(double area, int decimals = 2);
/// "12 min 05 s"
std::string duration(double seconds);

}  // namespace strandline::cli
