// Choices, cuts and segments as people write them.
#include <fmt/core.h>

#include <array>
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
        const std::size_t comma = pair.find(',');
        if (comma == std::string::npos) return fail(place, fmt::format("{} is no point", pair), remedy);
        const auto x = parse_length(pair.substr(0, comma), place),
                   y = parse_length(pair.substr(comma + 1), place);
        if (!x || !y) return fail(place, fmt::format("{} is no point", pair), remedy);
        cut.push_back({*x, *y});
        i = end;
    }
    if (auto closed = close(); !closed) return tl::unexpected(closed.error());
    return cuts;
}

}  // namespace strandline::fill
