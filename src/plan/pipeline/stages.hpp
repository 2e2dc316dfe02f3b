#pragma once
// The stages of a plan, each with what it needs: whoever keeps their results need not make them again.
#include "plan/pipeline/measured.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "plan/pipeline/strokes.hpp"

namespace strandline::pipeline {

/// A file that was read, without the hints that cannot be obeyed.
struct Read {
    svg::Document document;
    Warnings wrong_hints;
};

Outcome<DrawingOptions> drawing_options(const Options& options);
order::Options order_options(const Options& options, const Robot& robot);
/// Whether lines are drawn by hand.
bool by_hand(const std::vector<Edit>& edits);
/// The drawing before any edit. A file without shapes gives a bare one where lines are drawn by hand.
Outcome<Drawing> drawn(const Read& read, const Robot& robot, const DrawingOptions& options,
                       const std::vector<Edit>& edits, const Progress& progress);
/// What one plan leaves for the next.
struct Kept {
    KeptStrokes strokes;
    order::Memory order;
    trajectory::Pieces pieces;
    MeasuredPieces measured;
    Robot robot;      ///< that of `order`
    Options options;  ///< ... but for the budget of the search
};
/// All that comes after the drawing. `draft`, if there is one: by the row that was driven last, as far as it
/// can be mended; else by a short search. Its pieces become those of the drive.
Outcome<Plan> planned(const Read& read, Drawing drawing, const std::string& title, const Robot& robot,
                      const Options& options, const std::vector<Edit>& edits, Kept& kept,
                      std::vector<trajectory::Placed>* draft, const Progress& progress);

/// Only the search may be cut short: a drawing read by half would be planned as if it were whole.
Progress patient(Progress progress);

}  // namespace strandline::pipeline
