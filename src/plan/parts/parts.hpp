#pragma once
// Plans cut at stroke ends: for battery, tide or paint, and to go on after a stop. Also what a drive
// measures.
#include <string>
#include <variant>
#include <vector>

#include "plan/model/model.hpp"

namespace strandline::parts {

/// Metres, bends and time of a finished trajectory, into the figures that follow from it alone.
void measure(Figures& figures, const std::vector<Sample>& samples);

/// Whether every stroke is driven, as part, cuts and stroke_at need it; plans of this program are. Error: a
/// plan without strokes, or the stroke that is not driven.
Outcome<void> can_be_cut(const Plan& plan);

/// The strokes first .. end - 1 of the plan as a plan of its own, in the same order and along the same ways:
/// what was finished before is gone round as in the whole. It begins at rest where the lead to its first
/// stroke begins, and ends where its last stroke ends. Its drawing holds the elements that it draws; one that
/// it draws in part is named in a warning. 0 <= first < end <= strokes.
Plan part(const Plan& plan, int first, int end);

/// How much one part may be: seconds from rest to rest as part() times it, or metres driven with the rake up
/// or down, the ways in and out included.
struct Limit {
    double seconds = 0, metres = 0;  ///< 0: no limit
};
/// Where each part begins: the first is 0. A cut comes after a whole element where one fits, else at the end
/// of a stroke; a single stroke may be longer than the limit. O(samples) a part, times the ends that are
/// tried until the part keeps the limit: few.
std::vector<int> cuts(const Plan& plan, const Limit& limit);

/// Where to go on: seconds after the start, an element by its id, or near a place.
using From = std::variant<double, std::string, Point>;
/// The stroke that is being drawn, or comes next, at that time; the element's first one; the one whose rake
/// comes nearest. Error: a time after the end, an element that is not drawn.
Outcome<int> stroke_at(const Plan& plan, const From& from);

}  // namespace strandline::parts
