#include "fill_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units/units.hpp"

namespace strandline::cli {
namespace {

constexpr double width_per_tolerance = 200;  // less than that no sand shows

Outcome<std::optional<double>> positive(const std::string& text, const std::string& option) {
    if (text.empty()) return std::optional<double>{};
    const auto value = parse_length(text, option);
    if (!value) return tl::unexpected(value.error());
    if (!(*value > 0)) return fail(option, "must be above 0");
    return std::optional<double>(*value);
}

/// Reads options one after the other; the first error stays.
class Reader {
  public:
    template <class Value, class Read>
    void take(Value& field, Outcome<Read> read) {
        if (!error_ && !read) error_ = std::move(read.error());
        if (!error_) field = std::move(*read);
    }
    template <class Choice>
    void choose(Choice& field, const std::string& name, const char* option) {
        take(field, fill::named<Choice>(name, option));
    }
    const std::optional<Error>& error() const { return error_; }

  private:
    std::optional<Error> error_;
};

/// Cuts and choices that met nothing, as warnings.
void add_idle(Warnings& warnings, const std::vector<bool>& cuts_used,
              const std::vector<bool>& segments_used) {
    for (std::size_t i = 0; i < cuts_used.size(); ++i)
        if (!cuts_used[i])
            warnings.push_back(
                {"--cuts", fmt::format("cut {} parts nothing: draw it from edge to edge", i + 1)});
    for (std::size_t i = 0; i < segments_used.size(); ++i)
        if (!segments_used[i])
            warnings.push_back(
                {"--segments",
                 fmt::format("choice {} lies in no segment: name a point inside of one", i + 1)});
}

}  // namespace

Outcome<FillAsked> fill_asked(const FillArguments& arguments, const std::optional<Robot>& vehicle) {
    FillAsked asked;
    fill::Options& options = asked.options;
    Reader reader;
    reader.choose(options.style, arguments.style, "--style");
    reader.choose(options.join, arguments.join, "--join");
    reader.choose(options.narrow, arguments.narrow, "--narrow");
    reader.choose(options.insets, arguments.inset, "--inset");
    reader.choose(options.partition, arguments.partition, "--partition");
    options.shift = arguments.shift;
    reader.take(asked.width, positive(arguments.width, "--width"));
    reader.take(asked.spacing, positive(arguments.spacing, "--spacing"));
    if (!arguments.direction.empty())
        reader.take(options.direction, parse_angle(arguments.direction, "--direction"));
    reader.take(options.cuts, fill::cuts_of(arguments.cuts, "--cuts"));
    reader.take(options.segments, fill::segment_choices_of(arguments.segments, "--segments"));
    if (reader.error()) return tl::unexpected(*reader.error());
    options.one_stroke = arguments.one_stroke;
    for (const fill::Choice& choice : fill::choices_of(options))
        if (!choice.read)
            asked.unused.push_back(
                {fmt::format("--{}", choice.name),
                 fmt::format("does nothing with --style {}: it serves {}", arguments.style, choice.serves)});
    if (vehicle) {
        // The rake's own path may turn as tightly as the offset allows; a machine without an offset turns on
        // the spot.
        options.turn_radius =
            vehicle->min_radius > 0 ? 1.1 * std::hypot(vehicle->rake_offset, vehicle->rake_side) : 0;
        options.pins = vehicle->pins;
    } else {
        options.rake_turns = false;  // may lift, pivot and back up for nothing
        options.pivots = true;
    }
    asked.pins = arguments.pins;
    return asked;
}

Outcome<Filled> filled(FillAsked asked, const stages::FillTask& task, const std::string& place,
                       Warnings& warnings, const Progress& progress) {
    fill::Options& options = asked.options;
    const std::optional<double> width = asked.width ? asked.width : task.width;
    if (!width) return fail(place, "has no width, and the call neither", "give the rake's width by --width");
    options.width = *width;
    if (asked.pins) options.pins = *asked.pins;
    // Neighbouring passes share a pin, which the second one lifts: sand beside a bend is still reached.
    const bool shared = asked.pins && *asked.pins > 1;
    options.masked = shared;
    options.spacing = asked.spacing.value_or(shared ? *width * (*asked.pins - 1) / *asked.pins : *width);
    if (options.spacing > options.width)
        return fail("--spacing", "is wider than the rake", fmt::format("at most {}", *width));
    options.min_area = 0;  // the file names the one area it wants filled
    options.tolerance = options.width / width_per_tolerance;

    std::vector<bool> cuts_used(options.cuts.size()), segments_used(options.segments.size());
    std::vector<Stroke> strokes;
    std::vector<Polyline> ways;
    for (std::size_t i = 0; i < task.regions.size(); ++i) {
        progress.report("filling", static_cast<double>(i) / static_cast<double>(task.regions.size()));
        const std::string part = task.regions.size() == 1 ? place : fmt::format("{}, part {}", place, i + 1);
        const fill::Fill found = fill::fill_region(task.regions[i], 0, part, options);
        warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
        for (std::size_t k = 0; k < cuts_used.size(); ++k)
            if (found.cuts_used[k]) cuts_used[k] = true;
        for (std::size_t k = 0; k < segments_used.size(); ++k)
            if (found.segments_used[k]) segments_used[k] = true;
        strokes.insert(strokes.end(), found.strokes.begin(), found.strokes.end());
        ways.insert(ways.end(), found.ways.begin(), found.ways.end());
    }
    progress.report("filling", 1);
    warnings.insert(warnings.end(), asked.unused.begin(), asked.unused.end());
    if (options.style == fill::Style::zigzag) add_idle(warnings, cuts_used, segments_used);
    if (strokes.empty()) return fail(place, "nothing of it can be raked", "use a narrower rake");
    std::vector<rake::PinSpans> masks;
    if (asked.pins)
        masks =
            rake::pin_masks(task.regions, strokes, ways,
                            {.width = options.width, .pins = options.pins, .tolerance = options.tolerance});
    return Filled{rake::moves_of(strokes, ways, masks, options.pins, options.tolerance), strokes.size(),
                  options.width, options.pins};
}

rake::Account account_of(const Filled& filled, const stages::FillTask& task) {
    return rake::account_of(task.regions, filled.moves, {.width = filled.width, .pins = filled.pins});
}

}  // namespace strandline::cli
