// The stages of a plan one after the other; a Planner keeps them for the next one.
#include <algorithm>
#include <utility>

#include "plan/pipeline/hints.hpp"
#include "plan/pipeline/stages.hpp"

namespace strandline {

namespace pipeline {

Progress patient(Progress progress) {
    progress.stopped = [] { return false; };
    return progress;
}

bool by_hand(const std::vector<Edit>& edits) {
    return std::ranges::any_of(edits,
                               [](const Edit& edit) { return std::holds_alternative<DrawEdit>(edit); });
}

Outcome<Drawing> drawn(const Read& read, const Robot& robot, const DrawingOptions& options,
                       const std::vector<Edit>& edits, const Progress& progress) {
    if (by_hand(edits) && read.document.shapes.empty()) {
        Drawing bare;
        bare.canvas = options.canvas;
        return bare;
    }
    auto drawing = make_drawing(read.document, robot, options, patient(progress));
    if (drawing) return drawing;
    Error error = drawing.error();
    // What was left out is often why nothing is there.
    if (!read.document.warnings.empty())
        error.reason += " (" + sentence(read.document.warnings.front()) + ")";
    return tl::unexpected(error);
}

namespace {

Read without_wrong_hints(svg::Document document, const Robot& robot) {
    Read read{std::move(document), {}};
    read.wrong_hints = drop_wrong_hints(read.document, robot);
    return read;
}

/// All that a file's reading follows from.
struct ReadKey {
    std::string bytes;
    Options::Trace trace;
    Options::Text text;
    bool invert = false;
    double dpi = 0;
    Robot robot;        ///< whether hints suit it
    bool bare = false;  ///< no file: edits draw all there is
    bool operator==(const ReadKey&) const = default;
};

/// All that a drawing follows from, besides the file.
struct DrawingKey {
    Robot robot;
    Options::Fit place;
    Options::Field canvas;
    Options::Draw drawing;
    Options::Ink ink;
    double min_area = 0;
    bool bare = false;  ///< the file holds no shapes, and edits that draw make up for it
    bool operator==(const DrawingKey&) const = default;
};

}  // namespace
}  // namespace pipeline

struct Planner::Kept {
    pipeline::ReadKey read_key;
    std::optional<pipeline::Read> read;
    pipeline::DrawingKey drawing_key;
    std::optional<Drawing> drawing;
    pipeline::Kept stages;
};

Planner::Planner() : kept_(std::make_unique<Kept>()) {}
Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

Outcome<Plan> Planner::plan(const Source& source, const Robot& robot, const Options& options,
                            const std::vector<Edit>& edits, const Progress& progress) {
    return plan_or_draft(source, robot, options, edits, nullptr, progress);
}

Outcome<Draft> Planner::draft(const Source& source, const Robot& robot, const Options& options,
                              const std::vector<Edit>& edits, const Progress& progress) {
    Draft draft;
    auto plan = plan_or_draft(source, robot, options, edits, &draft.pieces, progress);
    if (!plan) return tl::unexpected(plan.error());
    draft.plan = std::move(*plan);
    return draft;
}

Plan whole(Draft draft) {
    if (draft.plan.samples.empty()) draft.plan.samples = trajectory::joined(draft.pieces);
    return std::move(draft.plan);
}

Outcome<Plan> Planner::plan_or_draft(const Source& source, const Robot& robot, const Options& options,
                                     const std::vector<Edit>& edits, std::vector<trajectory::Placed>* draft,
                                     const Progress& progress) {
    if (const auto fits = valid(options, robot); !fits) return tl::unexpected(fits.error());
    const auto asked = pipeline::drawing_options(options);
    if (!asked) return tl::unexpected(asked.error());
    const bool by_hand = pipeline::by_hand(edits);
    pipeline::ReadKey read_key{std::string(source.bytes),
                               options.trace,
                               options.text,
                               options.ink.invert,
                               options.drawing.dpi,
                               robot,
                               by_hand && source.bytes.empty()};
    if (!kept_->read || kept_->read_key != read_key) {
        auto document = read_key.bare ? Outcome<svg::Document>(svg::Document{})
                                      : read_source(source, options, pipeline::patient(progress));
        if (!document) return tl::unexpected(document.error());
        kept_->read = pipeline::without_wrong_hints(std::move(*document), robot);
        kept_->read_key = std::move(read_key);
        kept_->drawing.reset();
    }
    pipeline::DrawingKey drawing_key{robot,
                                     options.place,
                                     options.canvas,
                                     options.drawing,
                                     options.ink,
                                     options.fill.min_area,
                                     by_hand && kept_->read->document.shapes.empty()};
    if (!kept_->drawing || kept_->drawing_key != drawing_key) {
        auto drawing = pipeline::drawn(*kept_->read, robot, *asked, edits, progress);
        if (!drawing) return tl::unexpected(drawing.error());
        kept_->drawing = std::move(*drawing);
        kept_->drawing_key = std::move(drawing_key);
    }
    return pipeline::planned(*kept_->read, *kept_->drawing, source.title, robot, options, edits,
                             kept_->stages, draft, progress);
}

Outcome<Drawing> drawing_of(const Source& source, const Robot& robot, const Options& options,
                            const Progress& progress) {
    const auto asked = pipeline::drawing_options(options);
    if (!asked) return tl::unexpected(asked.error());
    auto document = read_source(source, options, progress);
    if (!document) return tl::unexpected(document.error());
    return pipeline::drawn(pipeline::without_wrong_hints(std::move(*document), robot), robot, *asked, {},
                           progress);
}

Outcome<Plan> make_plan(const Source& source, const Robot& robot, const Options& options,
                        const std::vector<Edit>& edits, const Progress& progress) {
    return Planner().plan(source, robot, options, edits, progress);
}

Outcome<Plan> make_plan(svg::Document document, const std::string& title, const Robot& robot,
                        const Options& options, const std::vector<Edit>& edits, const Progress& progress) {
    if (const auto fits = valid(options, robot); !fits) return tl::unexpected(fits.error());
    const auto asked = pipeline::drawing_options(options);
    if (!asked) return tl::unexpected(asked.error());
    const pipeline::Read read = pipeline::without_wrong_hints(std::move(document), robot);
    auto drawing = pipeline::drawn(read, robot, *asked, edits, progress);
    if (!drawing) return tl::unexpected(drawing.error());
    pipeline::Kept none;
    return pipeline::planned(read, std::move(*drawing), title, robot, options, edits, none, nullptr,
                             progress);
}

}  // namespace strandline
