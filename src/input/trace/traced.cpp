// Grey -> ink by a threshold -> regions by potrace.
#include <fmt/format.h>
#include <potracelib.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <memory>

#include "input/trace/trace.hpp"

namespace strandline::trace {
namespace {

constexpr std::size_t most_regions = 1'000'000;

using Histogram = std::array<std::size_t, 256>;

Histogram histogram_of(const Picture& picture) {
    Histogram counts{};
    for (const unsigned char grey : picture.grey) ++counts[grey];
    return counts;
}

/// potrace's bitmap: rows from below, the leftmost pixel in the highest bit of a word.
struct Bitmap {
    std::vector<potrace_word> words;
    potrace_bitmap_t map;
};
Bitmap bitmap_of(const Picture& picture, double threshold, bool invert) {
    constexpr int bits = sizeof(potrace_word) * CHAR_BIT;
    const int words_a_row = (picture.width + bits - 1) / bits;
    Bitmap bitmap{std::vector<potrace_word>(static_cast<std::size_t>(words_a_row) *
                                            static_cast<std::size_t>(picture.height)),
                  {picture.width, picture.height, words_a_row, nullptr}};
    bitmap.map.map = bitmap.words.data();
    const unsigned char* grey = picture.grey.data();
    for (int y = picture.height - 1; y >= 0; --y) {
        potrace_word* row = bitmap.map.map + std::ptrdiff_t{y} * words_a_row;
        for (int x = 0; x < picture.width; ++x)
            if ((*grey++ < 255 * threshold) != invert)
                row[x / bits] |= potrace_word{1} << static_cast<unsigned>(bits - 1 - x % bits);
    }
    return bitmap;
}

Path path_of(const potrace_curve_t& curve, int height) {
    const auto point = [&](const potrace_dpoint_t& p) { return Point{p.x, height - p.y}; };
    Path path{point(curve.c[curve.n - 1][2]), {}, true};
    for (int i = 0; i < curve.n; ++i) {
        const auto& c = curve.c[i];
        if (curve.tag[i] == POTRACE_CORNER) {
            path.segments.emplace_back(LineSegment{point(c[1])});
            path.segments.emplace_back(LineSegment{point(c[2])});
        } else {
            path.segments.emplace_back(CubicSegment{point(c[0]), point(c[1]), point(c[2])});
        }
    }
    return path;
}

svg::Shape shape_of(const potrace_path_t& outline, std::size_t number, int height) {
    svg::Shape shape;
    shape.id = fmt::format("region.{}", number);
    shape.subpaths.push_back(path_of(outline.curve, height));
    const Point at = shape.subpaths.front().start;
    shape.place = fmt::format("region {} at pixel ({:.0f}, {:.0f})", number, at.x, at.y);
    for (const potrace_path_t* hole = outline.childlist; hole; hole = hole->sibling)
        shape.subpaths.push_back(path_of(hole->curve, height));
    shape.fill_rule = svg::FillRule::even_odd;
    shape.fill = svg::Paint{};
    return shape;
}

void report_share(double share, void* progress) {
    static_cast<const Progress*>(progress)->report("tracing", share);
}

using State = std::unique_ptr<potrace_state_t, void (*)(potrace_state_t*)>;

State state_of(const Bitmap& bitmap, const Options& options, const Progress& progress) {
    const std::unique_ptr<potrace_param_t, void (*)(potrace_param_t*)> param(potrace_param_default(),
                                                                             potrace_param_free);
    if (!param) return {nullptr, potrace_state_free};
    param->turdsize = options.despeckle;
    param->alphamax = options.alphamax;
    param->opticurve = options.opttolerance > 0;
    param->opttolerance = options.opttolerance;
    Progress reported = progress;
    param->progress.callback = report_share;
    param->progress.data = &reported;
    return {potrace_trace(param.get(), &bitmap.map), potrace_state_free};
}

}  // namespace

Outcome<double> otsu(const Picture& picture) {
    const Histogram counts = histogram_of(picture);
    const auto pixels = static_cast<double>(picture.grey.size());
    double sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) sum += static_cast<double>(i * counts[i]);
    double below = 0, sum_below = 0, best = 0;
    // Between two values that part the picture alike lies their middle.
    std::size_t first = 0, last = 0;
    for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
        below += static_cast<double>(counts[i]);
        sum_below += static_cast<double>(i * counts[i]);
        const double above = pixels - below;
        if (below == 0 || above == 0) continue;
        const double apart = sum_below / below - (sum - sum_below) / above;
        const double variance = below * above * apart * apart;
        if (variance > best) best = variance, first = i;
        if (variance == best) last = i;
    }
    if (best == 0)
        return fail("", "the picture is all one colour", "choose one in which something is to be seen");
    return (static_cast<double>(first + last + 1) / 2) / 255;
}

Outcome<Traced> traced(const Picture& picture, const Options& options, const Progress& progress) {
    Outcome<double> threshold = options.threshold;
    if (options.threshold == 0) threshold = otsu(picture);
    if (!threshold) return tl::unexpected(threshold.error());
    Traced result{{}, *threshold, 0};
    const auto limit = 255 * *threshold;
    const auto dark = static_cast<std::size_t>(
        std::ranges::count_if(picture.grey, [&](unsigned char grey) { return grey < limit; }));
    if (dark == 0 || dark == picture.grey.size())
        return fail("",
                    fmt::format("nothing of the picture is {} than the threshold of {:.3g}",
                                dark == 0 ? "darker" : "brighter", *threshold),
                    "set trace.threshold to another value from 0 to 1, or to 0 to have it found");

    const State state = state_of(bitmap_of(picture, *threshold, options.invert), options, progress);
    if (!state || state->status != POTRACE_STATUS_OK)
        return fail("", "the picture is too intricate to be traced", "scale it down");
    svg::Document& document = result.document;
    for (const potrace_path_t* path = state->plist; path; path = path->next) {
        if (path->sign != '+') continue;
        if (document.shapes.size() == most_regions)
            return fail("", fmt::format("the picture has more than {} regions", most_regions),
                        "raise trace.despeckle, or scale the picture down");
        document.shapes.push_back(shape_of(*path, document.shapes.size() + 1, picture.height));
        result.holes += document.shapes.back().subpaths.size() - 1;
    }
    if (document.shapes.empty())
        return fail(
            "", fmt::format("the ink in the picture is only specks of up to {} pixels", options.despeckle),
            "lower trace.despeckle");
    document.view = {{0, 0}, {double(picture.width), double(picture.height)}};
    document.size_metres = picture.size_metres;
    document.warnings = picture.warnings;
    return result;
}

}  // namespace strandline::trace
