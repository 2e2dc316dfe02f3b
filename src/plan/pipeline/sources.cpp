// A file's bytes -> the drawing in it.
#include <algorithm>
#include <optional>
#include <utility>

#include "input/trace/trace.hpp"
#include "input/typeset/typeset.hpp"
#include "plan/pipeline/pipeline.hpp"

namespace strandline {

Outcome<trace::Traced> trace_source(const Source& source, const Options& options, const Progress& progress) {
    const auto picture = trace::read_picture(source.bytes);
    if (!picture) return tl::unexpected(picture.error());
    return trace::traced(*picture,
                         {.threshold = options.trace.threshold,
                          .invert = options.ink.invert,
                          .despeckle = options.trace.despeckle,
                          .alphamax = options.trace.alphamax,
                          .opttolerance = options.trace.opttolerance},
                         progress);
}

namespace {

/// SVG with its text as outlines. Fonts are looked for only where there is text: that takes a while.
Outcome<svg::Document> read_svg(const Source& source, const Options& options, const Progress& progress) {
    std::optional<typeset::Typesetter> typesetter;
    Warnings fonts;
    const auto outlines = [&](const svg::Text& text) -> Outcome<std::vector<std::vector<Path>>> {
        if (!typesetter) typesetter.emplace();
        auto set = typesetter->outlines(text, {.substitutes = options.text.substitutes});
        if (!set) return tl::unexpected(set.error());
        // Each once, at its first place: a page of text in one font is one warning.
        for (const Warning& warning : set->warnings)
            if (std::ranges::find(fonts, warning.reason, &Warning::reason) == fonts.end())
                fonts.push_back(warning);
        return std::move(set->spans);
    };
    auto document =
        svg::read(source.bytes, {.dpi = options.drawing.dpi, .text_outlines = outlines}, progress);
    if (document) document->warnings.insert(document->warnings.end(), fonts.begin(), fonts.end());
    return document;
}

}  // namespace

Outcome<svg::Document> read_source(const Source& source, const Options& options, const Progress& progress) {
    if (trace::format_of(source.bytes).empty()) return read_svg(source, options, progress);
    auto traced = trace_source(source, options, progress);
    if (!traced) return tl::unexpected(traced.error());
    // What is bright is raked: so what was traced is shown bright, as it is in the picture.
    if (options.ink.invert)
        for (svg::Shape& shape : traced->document.shapes) shape.fill->colour = {255, 255, 255};
    return std::move(traced->document);
}

}  // namespace strandline
