// Integers for exact predicates: school methods in words of 64 bits.
#include "math/region/exact.hpp"

#include <algorithm>
#include <cmath>

namespace strandline::exact {

__extension__ using Wide = unsigned __int128;

bool Integer::smaller(const Integer& a, const Integer& b) {
    if (a.size_ != b.size_) return a.size_ < b.size_;
    for (std::size_t i = a.size_; i-- > 0;)
        if (a.words_[i] != b.words_[i]) return a.words_[i] < b.words_[i];
    return false;
}

Integer Integer::sum(const Integer& a, const Integer& b, bool b_negative) {
    Integer result;
    if (a.negative_ == b_negative) {
        const Integer &longer = a.size_ < b.size_ ? b : a, &shorter = a.size_ < b.size_ ? a : b;
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < longer.size_; ++i) {
            const Wide word = Wide{longer.words_[i]} + (i < shorter.size_ ? shorter.words_[i] : 0) + carry;
            result.words_[i] = static_cast<std::uint64_t>(word);
            carry = static_cast<std::uint64_t>(word >> 64);
        }
        result.size_ = longer.size_;
        if (carry != 0 && result.size_ < most_words) result.words_[result.size_++] = carry;
        result.negative_ = b_negative;
        return result;
    }
    const bool swapped = smaller(a, b);
    const Integer &more = swapped ? b : a, &less = swapped ? a : b;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < more.size_; ++i) {
        const Wide word = Wide{more.words_[i]} - (i < less.size_ ? less.words_[i] : 0) - borrow;
        result.words_[i] = static_cast<std::uint64_t>(word);
        borrow = static_cast<std::uint64_t>(word >> 64) & 1;
    }
    result.size_ = more.size_;
    result.trim();
    result.negative_ = swapped ? b_negative : a.negative_;
    return result;
}

Integer operator*(const Integer& a, const Integer& b) {
    Integer result;
    if (a.size_ == 0 || b.size_ == 0) return result;
    result.size_ = std::min(a.size_ + b.size_, Integer::most_words);
    std::fill_n(result.words_.begin(), result.size_, 0);
    for (std::size_t i = 0; i < a.size_; ++i) {
        std::uint64_t carry = 0;
        const std::size_t end = std::min(b.size_, result.size_ - i);
        for (std::size_t j = 0; j < end; ++j) {
            const Wide word = Wide{a.words_[i]} * b.words_[j] + result.words_[i + j] + carry;
            result.words_[i + j] = static_cast<std::uint64_t>(word);
            carry = static_cast<std::uint64_t>(word >> 64);
        }
        if (i + end < result.size_) result.words_[i + end] = carry;
    }
    result.trim();
    result.negative_ = a.negative_ != b.negative_;
    return result;
}

std::pair<double, int> Integer::scaled() const {
    if (size_ == 0) return {0, 0};
    constexpr double word = 4294967296.0;  // half a word of these: Boost rounds after each
    const auto half = [&](std::size_t i) {
        return static_cast<double>(static_cast<std::uint32_t>(words_[i / 2] >> (i % 2 == 0 ? 0 : 32)));
    };
    const std::size_t halves = 2 * size_ - (words_[size_ - 1] >> 32 == 0 ? 1 : 0);
    double mantissa = 0;
    for (std::size_t i = halves, used = 0; i > 0 && used < 3; ++used) mantissa = mantissa * word + half(--i);
    return {negative_ ? -mantissa : mantissa, halves > 3 ? static_cast<int>((halves - 3) * 32) : 0};
}

double ToDouble::operator()(const Integer& a) const {
    const auto [mantissa, exponent] = a.scaled();
    return std::ldexp(mantissa, exponent);
}

}  // namespace strandline::exact
