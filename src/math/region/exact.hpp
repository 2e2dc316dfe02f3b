#pragma once
// Integers for the exact predicates of Boost.Polygon's Voronoi diagram. Private to the room.
//
// The outlines of insets are full of arcs: chords that touch one circle, whose centre many of them share.
// There the diagram's quick predicates fail and the exact ones decide, in products of twenty words and more;
// Boost's own integers multiply in words of 32 bits and copy 264 bytes each time, which was most of a
// diagram's time. These hold the same numbers and give the same doubles, bit for bit.
#include <array>
#include <boost/polygon/detail/voronoi_ctypes.hpp>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace strandline::exact {

/// Sign and magnitude, at most 2048 bits: what Boost proves enough for coordinates of 32 bits. O(1) but
/// products: O(n m) in words of 64 bits.
class Integer {
  public:
    Integer() = default;
    Integer(std::int64_t value) : size_(value == 0 ? 0 : 1), negative_(value < 0) {
        words_[0] = negative_ ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    }
    Integer(std::int32_t value) : Integer(std::int64_t{value}) {}
    Integer(const Integer& other) { *this = other; }
    Integer& operator=(const Integer& other) {
        size_ = other.size_;
        negative_ = other.negative_;
        for (std::size_t i = 0; i < size_; ++i) words_[i] = other.words_[i];
        return *this;
    }

    bool is_zero() const { return size_ == 0; }
    bool is_negative() const { return size_ > 0 && negative_; }

    Integer operator-() const {
        Integer result = *this;
        result.negative_ = !negative_;
        return result;
    }
    friend Integer operator+(const Integer& a, const Integer& b) { return sum(a, b, b.negative_); }
    friend Integer operator-(const Integer& a, const Integer& b) { return sum(a, b, !b.negative_); }
    friend Integer operator*(const Integer& a, const Integer& b);

    /// The value as m * 2^e, m from its highest 96 bits, rounded as Boost rounds it.
    std::pair<double, int> scaled() const;

  private:
    static constexpr std::size_t most_words = 32;

    static Integer sum(const Integer& a, const Integer& b, bool b_negative);
    static bool smaller(const Integer& a, const Integer& b);  // of magnitudes
    void trim() {
        while (size_ > 0 && words_[size_ - 1] == 0) --size_;
    }

    std::size_t size_ = 0;
    bool negative_ = false;
    std::array<std::uint64_t, most_words> words_;  // lowest first; only the first size_ are set
};

inline bool is_pos(const Integer& a) { return !a.is_zero() && !a.is_negative(); }
inline bool is_neg(const Integer& a) { return a.is_negative(); }
inline bool is_zero(const Integer& a) { return a.is_zero(); }

struct ToDouble : boost::polygon::detail::type_converter_fpt {
    using boost::polygon::detail::type_converter_fpt::operator();
    double operator()(const Integer& a) const;
};

struct ToWideExponent {
    boost::polygon::detail::extended_exponent_fpt<double> operator()(const Integer& a) const {
        const auto [mantissa, exponent] = a.scaled();
        return {mantissa, exponent};
    }
};

/// The arithmetic of a Voronoi diagram: Boost's, but for the integers.
struct Arithmetic : boost::polygon::detail::voronoi_ctype_traits<std::int32_t> {
    using big_int_type = Integer;
    using to_fpt_converter_type = ToDouble;
    using to_efpt_converter_type = ToWideExponent;
};

}  // namespace strandline::exact
