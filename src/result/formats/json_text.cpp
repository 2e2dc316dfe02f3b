#include "result/formats/json_text.hpp"

#include <fmt/compile.h>

#include <algorithm>
#include <cmath>

namespace strandline::formats {
namespace {

/// Length of the UTF-8 sequence that starts here, 0 where none does (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto within = [&](std::size_t i, unsigned low, unsigned high) {
        return i < text.size() && byte(i) >= low && byte(i) <= high;
    };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return within(1, 0x80, 0xBF) ? 2 : 0;
    if (first >= 0xE0 && first <= 0xEF) {
        const unsigned low = first == 0xE0 ? 0xA0 : 0x80, high = first == 0xED ? 0x9F : 0xBF;
        return within(1, low, high) && within(2, 0x80, 0xBF) ? 3 : 0;
    }
    if (first >= 0xF0 && first <= 0xF4) {
        const unsigned low = first == 0xF0 ? 0x90 : 0x80, high = first == 0xF4 ? 0x8F : 0xBF;
        return within(1, low, high) && within(2, 0x80, 0xBF) && within(3, 0x80, 0xBF) ? 4 : 0;
    }
    return 0;
}

}  // namespace

void add(Text& text, std::string_view piece) { text.append(piece.data(), piece.data() + piece.size()); }

void add_number(Text& text, double value) {
    if (!std::isfinite(value))
        add(text, "null");
    else if (value == 0)
        add(text, std::signbit(value) ? "-0.0" : "0");  // readers take "-0" for the whole number 0
    else
        fmt::format_to(fmt::appender(text), FMT_COMPILE("{}"), value);
}

void add_number(Text& text, long long value) {
    fmt::format_to(fmt::appender(text), FMT_COMPILE("{}"), value);
}

void add_string(Text& text, std::string_view value) {
    text.push_back('"');
    while (!value.empty()) {
        const std::size_t n = utf8_length(value);
        const char c = value.front();
        if (n == 0)
            add(text, "\xEF\xBF\xBD");
        else if (c == '"' || c == '\\') {
            text.push_back('\\');
            text.push_back(c);
        } else if (n == 1 && static_cast<unsigned char>(c) < 0x20)
            fmt::format_to(fmt::appender(text), "\\u{:04x}", static_cast<unsigned>(c));
        else
            add(text, value.substr(0, n));
        value.remove_prefix(std::max<std::size_t>(n, 1));
    }
    text.push_back('"');
}

void add_fixed(Text& text, double value, int decimals) {
    const std::size_t before = text.size();
    fmt::format_to(fmt::appender(text), "{:.{}f}", value, decimals);
    const std::string_view digits(text.data() + before, text.size() - before);
    if (digits.front() == '-' && digits.find_first_not_of("-0.") == std::string_view::npos) {
        std::copy(text.data() + before + 1, text.data() + text.size(), text.data() + before);
        text.resize(text.size() - 1);
    }
}

}  // namespace strandline::formats
