#pragma once
// Texts with numbers, compared word by word: numbers within a tolerance, all else to the letter.
#include <charconv>
#include <cmath>
#include <sstream>
#include <string>

namespace strandline::golden {

/// Different machines round transcendental functions differently in the last bits; a micrometre is far below
/// a pin.
inline constexpr double tolerance = 1e-6;

/// "" when equal, else the first difference with its line number.
inline std::string difference(const std::string& expected, const std::string& found) {
    std::istringstream a(expected), b(found);
    std::string line_a, line_b;
    for (int line = 1;; ++line) {
        const bool more_a = static_cast<bool>(std::getline(a, line_a)),
                   more_b = static_cast<bool>(std::getline(b, line_b));
        if (!more_a && !more_b) return {};
        const auto report = [&] {
            return "line " + std::to_string(line) + "\n  expected: " + (more_a ? line_a : "(the end)") +
                   "\n  found:    " + (more_b ? line_b : "(the end)");
        };
        if (more_a != more_b) return report();
        std::istringstream words_a(line_a), words_b(line_b);
        for (std::string x, y;;) {
            const bool word_a = static_cast<bool>(words_a >> x), word_b = static_cast<bool>(words_b >> y);
            if (word_a != word_b) return report();
            if (!word_a) break;
            if (x == y) continue;
            double u = 0, v = 0;
            const bool numbers =
                std::from_chars(x.data(), x.data() + x.size(), u).ptr == x.data() + x.size() &&
                std::from_chars(y.data(), y.data() + y.size(), v).ptr == y.data() + y.size();
            if (!numbers || std::abs(u - v) > tolerance * std::max(1.0, std::abs(u))) return report();
        }
    }
}

}  // namespace strandline::golden
