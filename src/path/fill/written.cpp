// Choices, cuts and segments as people write them.
#include <fmt/core.h>

#include <array>
#include <sstream>
#include <string_view>

#include "base/units/units.hpp"
#include "path/fill/fill.hpp"

namespace strandline::fill {
namespace {

/// The enumerators' names, in their order.
template <class Choice>
struct Names;
template <>
struct Names<Style> {
    static constexpr std::array<std::string_view, 3> list{"rings", "spiral", "zigzag"};
};
template <>
struct Names<Partition> {
    static constexpr std::array<std::string_view, 4> list{"none", "monotone", "optimal-convex", "fitted"};
};
template <>
struct Names<Insets> {
    static constexpr std::array<std::string_view, 2> list{"offset", "skeleton"};
};
template <>
struct Names<Join> {
    static constexpr std::array<std::string_view, 4> list{"half-step", "nearest", "alternating",
                                                          "longest-edge"};
};
template <>
struct Names<Narrow> {
    static constexpr std::array<std::string_view, 2> list{"single-pass", "warn"};
};
template <>
struct Names<Tips> {
    static constexpr std::array<std::string_view, 3> list{"off", "border", "all"};
};

/// "x,y" -> a point; absent if it is none.
std::optional<Point> point_of(const std::string& pair) {
    const std::size_t comma = pair.find(',');
    if (comma == std::string::npos) return {};
    const auto x = parse_length(pair.substr(0, comma), ""), y = parse_length(pair.substr(comma + 1), "");
    if (!x || !y) return {};
    return Point{*x, *y};
}

}  // namespace

template <class Choice>
Outcome<Choice> named(const std::string& name, const std::string& place) {
    constexpr auto& list = Names<Choice>::list;
    std::string listed = "use ";
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i] == name) return static_cast<Choice>(i);
        listed += fmt::format("{}{}", i == 0 ? "" : i + 1 < list.size() ? ", " : " or ", list[i]);
    }
    return fail(place, fmt::format("{} is not one of its choices", name), listed);
}
template Outcome<Style> named<Style>(const std::string&, const std::string&);
template Outcome<Partition> named<Partition>(const std::string&, const std::string&);
template Outcome<Insets> named<Insets>(const std::string&, const std::string&);
template Outcome<Join> named<Join>(const std::string&, const std::string&);
template Outcome<Narrow> named<Narrow>(const std::string&, const std::string&);
template Outcome<Tips> named<Tips>(const std::string&, const std::string&);

Outcome<std::vector<Polyline>> cuts_of(const std::string& text, const std::string& place) {
    constexpr auto remedy = "write x,y x,y for a line and ; between lines, as in 0,2 4,2; 1,0 1,5";
    std::vector<Polyline> cuts;
    Polyline cut;
    const auto close = [&]() -> Outcome<void> {
        if (cut.size() == 1)
            return fail(place, fmt::format("cut {} has one point only", cuts.size() + 1), remedy);
        if (!cut.empty()) cuts.push_back(std::move(cut));
        cut.clear();
        return {};
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == ';') {
            if (auto closed = close(); !closed) return tl::unexpected(closed.error());
            ++i;
            continue;
        }
        if (text[i] == ' ') {
            ++i;
            continue;
        }
        const std::size_t end = std::min(text.find_first_of(" ;", i), text.size());
        const std::string pair = text.substr(i, end - i);
        const std::optional<Point> point = point_of(pair);
        if (!point) return fail(place, fmt::format("{} is no point", pair), remedy);
        cut.push_back(*point);
        i = end;
    }
    if (auto closed = close(); !closed) return tl::unexpected(closed.error());
    return cuts;
}

Outcome<std::vector<SegmentChoice>> segment_choices_of(const std::string& text, const std::string& place) {
    constexpr auto remedy =
        "write x,y and direction=angle or style=name, ; between segments, as in 2,3 direction=30deg; 5,1 "
        "style=rings";
    std::vector<SegmentChoice> choices;
    std::istringstream segments(text);
    for (std::string segment; std::getline(segments, segment, ';');) {
        std::istringstream words(segment);
        std::string word;
        if (!(words >> word)) continue;
        const auto wrong = [&](const std::string& reason) {
            return fail(place, fmt::format("segment {}: {}", choices.size() + 1, reason), remedy);
        };
        const std::optional<Point> point = point_of(word);
        if (!point) return wrong(word + " is no point");
        SegmentChoice choice{*point};
        while (words >> word) {
            const std::string name = word.substr(0, word.find('='));
            const std::string value = word.substr(std::min(name.size() + 1, word.size()));
            if (name == "direction") {
                const auto angle = parse_angle(value, place);
                if (!angle) return wrong(fmt::format("direction: {}", angle.error().reason));
                choice.direction = *angle;
            } else if (name == "style") {
                const auto style = named<Style>(value, place);
                if (!style)
                    return wrong(fmt::format("style: {}; {}", style.error().reason, style.error().remedy));
                choice.style = *style;
            } else {
                return wrong(word + " is neither direction=angle nor style=name");
            }
        }
        if (!choice.direction && !choice.style) return wrong("has neither a direction nor a style");
        choices.push_back(choice);
    }
    return choices;
}

}  // namespace strandline::fill
