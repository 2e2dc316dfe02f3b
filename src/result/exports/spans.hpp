#pragma once
// Private to the room: the drive cut where the tool goes down or up, and what several formats ask of a plan.
#include <cstddef>
#include <vector>

#include "result/exports/exports.hpp"

namespace strandline::exports {

/// Samples first .. last (both included) between which some pin is down, or none is; at most one stroke.
/// Neighbouring spans share a sample.
struct Span {
    std::size_t first = 0, last = 0;
    bool down = false;
    int stroke = -1;
};
/// All of the drive in order. O(samples).
std::vector<Span> spans_of(const std::vector<Sample>& samples);
/// Where one tool goes that draws what the pins do: along the middle of the stroke's pins. O(samples).
Polyline tool_track(const Plan& plan, const Span& span);
/// The sample from which the robot sets out after each of the plan's stops.
std::vector<std::size_t> stop_samples(const Plan& plan, const std::vector<Sample>& samples);

/// How often the robot begins to back up. O(samples).
int times_backing(const std::vector<Sample>& samples);
/// The plan's place on earth; a warning where none is set.
Site site_of(const Plan& plan, Warnings& warnings);
/// A hint of the element that the stroke belongs to; `otherwise` where it has none.
std::string hint_of(const Plan& plan, int stroke, const char* name, const std::string& otherwise);
/// Of the element that the stroke belongs to; nullptr: there is none.
const Element* element_of(const Plan& plan, int stroke);

}  // namespace strandline::exports
