// Hints by name, and the rules that give them to layers, colours and ids.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "base/units/units.hpp"
#include "plan/model/model.hpp"

namespace strandline {
namespace {

constexpr std::string_view fill_prefix = "fill-";

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\n"), last = text.find_last_not_of(" \t\n");
    return first == std::string_view::npos ? std::string()
                                           : std::string(text.substr(first, last - first + 1));
}

std::vector<std::string> split(std::string_view text, char at) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(at, begin), text.size());
        if (std::string part = trimmed(text.substr(begin, end - begin)); !part.empty())
            parts.push_back(std::move(part));
        begin = end + 1;
    }
    return parts;
}

/// Whether a part that `,` or `;` cut off is the rest of a value before it ("fill-cuts=0,2 4,2"): it begins
/// like a number. Names of hints and of what a rule is for begin with a letter.
bool goes_on(std::string_view part) { return part.find_first_of("0123456789+-.") == 0; }

/// The parts, but for those that belong to the one before.
std::vector<std::string> split_before_names(std::string_view text, char at) {
    std::vector<std::string> parts;
    for (std::string& part : split(text, at))
        if (!parts.empty() && goes_on(part))
            parts.back() += at + part;
        else
            parts.push_back(std::move(part));
    return parts;
}

Outcome<void> whole_from(const svg::Hint& hint, int least) {
    int value = 0;
    const auto [end, error] =
        std::from_chars(hint.value.data(), hint.value.data() + hint.value.size(), value);
    if (error == std::errc{} && end == hint.value.data() + hint.value.size() && value >= least) return {};
    return fail(hint.name, fmt::format("\"{}\" is not a whole number", hint.value),
                fmt::format("give one from {}", least));
}

Outcome<InkRule> rule_of(const std::string& text) {
    const auto refuse = [&](const char* reason) {
        return fail("rule \"" + text + "\"", reason,
                    "write for example \"layer=Outline: pins=3, fill-style=zigzag\"");
    };
    // Names may hold colons ("path@3:7"): the last one before the first hint's "=".
    const std::size_t equals = text.find('='),
                      hint_equals = text.find('=', std::min(equals, text.size() - 1) + 1);
    const std::size_t colon = text.rfind(':', hint_equals);
    if (equals == std::string::npos || colon == std::string::npos || equals > colon)
        return refuse("does not say what it is for");
    InkRule rule;
    const std::string of = trimmed(text.substr(0, equals));
    if (of == "layer")
        rule.of = InkRule::Of::layer;
    else if (of == "colour" || of == "color")
        rule.of = InkRule::Of::colour;
    else if (of == "id")
        rule.of = InkRule::Of::id;
    else
        return refuse("is for neither a layer nor a colour nor an id");
    rule.pattern = trimmed(text.substr(equals + 1, colon - equals - 1));
    if (rule.pattern.empty()) return refuse("names nothing");
    if (rule.of == InkRule::Of::colour) {
        std::ranges::transform(rule.pattern, rule.pattern.begin(),
                               [](char c) { return c >= 'A' && c <= 'F' ? static_cast<char>(c + 32) : c; });
        if (rule.pattern.find_first_not_of("#0123456789abcdef*") != std::string::npos ||
            (rule.pattern.size() != 7 && rule.pattern.find('*') == std::string::npos))
            return refuse("names a colour otherwise than as #rrggbb");
    }
    for (const std::string& part : split_before_names(text.substr(colon + 1), ',')) {
        const std::size_t at = part.find('=');
        if (at == std::string::npos) return refuse("has a hint without a value");
        const svg::Hint hint{trimmed(part.substr(0, at)), trimmed(part.substr(at + 1))};
        if (auto fine = valid(hint); !fine) {
            fine.error().place = "rule \"" + text + "\", " + fine.error().place;
            return tl::unexpected(fine.error());
        }
        rule.hints.push_back(hint);
    }
    if (rule.hints.empty()) return refuse("asks for nothing");
    return rule;
}

}  // namespace

bool is_fill_hint(const svg::Hint& hint) { return hint.name.starts_with(fill_prefix); }

Outcome<void> set(Options& options, const svg::Hint& fill_hint) {
    std::string key = "fill." + fill_hint.name.substr(fill_prefix.size());
    std::ranges::replace(key, '-', '_');
    auto done = set(options, key, fill_hint.value);
    if (!done) done.error().place = fill_hint.name;
    return done;
}

Outcome<void> valid(const svg::Hint& hint) {
    if (hint.name == "ink") {
        if (hint.value == "on" || hint.value == "off") return {};
        return fail(hint.name, fmt::format("\"{}\" is neither on nor off", hint.value));
    }
    if (hint.name == "pins" || hint.name == "tool") return whole_from(hint, 1);
    if (hint.name == "order") return whole_from(hint, std::numeric_limits<int>::min());
    if (hint.name == "start") return whole_from(hint, -1);
    if (hint.name == "pause") {
        if (!hint.value.empty()) return {};
        return fail(hint.name, "says nothing of what the stop is for", "write for example \"another rake\"");
    }
    if (hint.name == "field") {
        if (hint.value == "keep-out" || hint.value == "border") return {};
        return fail(hint.name, fmt::format("\"{}\" is neither keep-out nor border", hint.value));
    }
    if (Options scratch; is_fill_hint(hint)) return set(scratch, hint);
    return fail(hint.name, "there is no such hint",
                "use ink, pins, tool, order, start, pause, field or fill-*");
}

Outcome<std::vector<InkRule>> rules_of(const std::string& text) {
    std::vector<InkRule> rules;
    for (const std::string& part : split_before_names(text, ';')) {
        auto rule = rule_of(part);
        if (!rule) return tl::unexpected(rule.error());
        rules.push_back(std::move(*rule));
    }
    return rules;
}

std::vector<std::string> names_of(const std::string& text) { return split(text, ';'); }

Outcome<std::vector<Polygon>> outlines_of(const std::string& text, const std::string& place) {
    constexpr auto remedy =
        "write x,y x,y x,y for an area and ; between areas, as in 0,0 2,0 1,2; 5,5 6,5 6,6";
    constexpr double least_area = 1e-6;  // m^2
    std::vector<Polygon> outlines;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ';');) {
        std::istringstream words(part);
        Polygon outline;
        for (std::string word; words >> word;) {
            const std::size_t comma = word.find(',');
            const auto x = parse_length(word.substr(0, comma), place),
                       y = parse_length(comma == std::string::npos ? "" : word.substr(comma + 1), place);
            if (!x || !y) return fail(place, fmt::format("{} is no point", word), remedy);
            outline.push_back({*x, *y});
        }
        if (outline.empty()) continue;
        if (outline.size() < 3 || area(outline) < least_area)
            return fail(place, fmt::format("outline {} bounds no area", outlines.size() + 1), remedy);
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

}  // namespace strandline
