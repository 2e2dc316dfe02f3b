// libFuzzer on the SVG reader: any bytes give a document that keeps its contract or one error with a reason.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "svg/contract.hpp"

namespace {

using namespace strandline;

/// A box for each letter: the code behind the outliner is driven without a font.
Outcome<std::vector<std::vector<Path>>> boxes(const svg::Text& text) {
    std::vector<std::vector<Path>> outlines;
    for (const auto& span : text.spans) {
        auto& letters = outlines.emplace_back();
        for (std::size_t i = 0; i < span.text.size() && i < 10; ++i) {
            const double x = static_cast<double>(i) * span.size;
            letters.push_back(path_through({{x, 0}, {x + span.size, 0}, {x, span.size}}, true));
        }
    }
    return outlines;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(data, data + size);
    // Small limits, so that an input that reaches one does so in milliseconds.
    const svg::ReadOptions options{.limits = {.bytes = 1u << 20,
                                              .depth = 100,
                                              .elements = 10'000,
                                              .expanded = 1'000,
                                              .segments = 20'000,
                                              .steps = 1'000'000},
                                   .text_outlines = boxes};
    const auto document = svg::read(bytes, options);
    if (document ? !svg::keeps_contract(*document) : document.error().reason.empty()) {
        std::fputs("the contract of docs/svg.md is broken\n", stderr);
        std::abort();
    }
    return 0;
}
