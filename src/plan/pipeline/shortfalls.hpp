#pragma once
// What the finished drive falls short of, in words.
#include "plan/model/model.hpp"

namespace strandline::pipeline {

/// Adds warnings to a plan whose samples and strokes are there: spans that the rake cannot follow; lifts
/// within areas that were to be raked in one stroke, counted as a fallback.
void say_shortfalls(Plan& plan);

}  // namespace strandline::pipeline
