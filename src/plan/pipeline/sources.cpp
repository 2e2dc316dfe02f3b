// A file's bytes -> the drawing in it.
#include "plan/pipeline/pipeline.hpp"

namespace strandline {

Outcome<svg::Document> read_source(const Source& source, const Options& options, const Progress& progress) {
    return svg::read(source.bytes, {.dpi = options.drawing.dpi}, progress);
}

}  // namespace strandline
