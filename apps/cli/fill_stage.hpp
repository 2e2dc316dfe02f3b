#pragma once
// The stage `fill` by itself, for the program and the Python module: what is asked for, and what comes of it.
#include <optional>
#include <vector>

#include "commands.hpp"
#include "machine/robot/robot.hpp"
#include "result/stages/stages.hpp"

namespace strandline::cli {

struct FillAsked {
    fill::Options options;  ///< without width and what follows from it
    std::optional<double> width, spacing;
    std::optional<int> pins;
    Warnings unused;  ///< options that this style does not read
};
/// Texts -> values, but for input, output and vehicle. No vehicle: one that may lift, pivot and back up for
/// nothing. Error: which option, and why.
Outcome<FillAsked> fill_asked(const FillArguments& arguments, const std::optional<Robot>& vehicle);

struct Filled {
    std::vector<rake::Move> moves;
    std::size_t strokes = 0;
    double width = 0;
    int pins = 0;
};
/// The polygon filled; `place` names it in errors and warnings. Error: no width, a spacing wider than it,
/// nothing can be raked. As fill::fill_region for each part of the polygon.
Outcome<Filled> filled(FillAsked asked, const stages::FillTask& task, const std::string& place,
                       Warnings& warnings, const Progress& progress);
/// What that leaves in the sand.
rake::Account account_of(const Filled& filled, const stages::FillTask& task);

}  // namespace strandline::cli
