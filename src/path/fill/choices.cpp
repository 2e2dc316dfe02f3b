// Which choices serve which style.
#include <algorithm>

#include "path/fill/fill.hpp"

namespace strandline::fill {

std::vector<Choice> choices_of(const Options& options) {
    const Options plain;
    // Segments of a zigzag may be raked in another style.
    const auto rakes = [&](Style style) {
        return options.style == style || (options.style == Style::zigzag &&
                                          std::ranges::any_of(options.segments, [&](const SegmentChoice& s) {
                                              return s.style == style;
                                          }));
    };
    const bool rings = rakes(Style::rings), spiral = rakes(Style::spiral);
    const bool zigzag = options.style == Style::zigzag;
    std::vector<Choice> choices;
    const auto look = [&](bool asked, bool read, std::string_view choice, std::string_view serves) {
        if (asked) choices.push_back({choice, serves, read});
    };
    look(options.insets != plain.insets, rings || spiral, "inset", "rings and spiral");
    look(options.join != plain.join, rings, "join", "rings");
    look(options.shift != plain.shift, spiral, "shift", "spiral");
    look(options.direction.has_value(), zigzag, "direction", "zigzag");
    look(options.partition != plain.partition, zigzag, "partition", "zigzag");
    look(!options.cuts.empty(), zigzag, "cuts", "zigzag");
    look(!options.segments.empty(), zigzag, "segments", "zigzag");
    look(options.part_inset != plain.part_inset, zigzag, "part_inset", "zigzag");
    look(options.border != plain.border, zigzag, "border", "zigzag");
    look(options.rake_turns != plain.rake_turns, zigzag, "rake_turns", "zigzag");
    return choices;
}

}  // namespace strandline::fill
