// A file's bytes -> the drawing in it.
#include <utility>

#include "input/trace/trace.hpp"
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

Outcome<svg::Document> read_source(const Source& source, const Options& options, const Progress& progress) {
    if (trace::format_of(source.bytes).empty())
        return svg::read(source.bytes, {.dpi = options.drawing.dpi}, progress);
    auto traced = trace_source(source, options, progress);
    if (!traced) return tl::unexpected(traced.error());
    // What is bright is raked: so what was traced is shown bright, as it is in the picture.
    if (options.ink.invert)
        for (svg::Shape& shape : traced->document.shapes) shape.fill->colour = {255, 255, 255};
    return std::move(traced->document);
}

}  // namespace strandline
