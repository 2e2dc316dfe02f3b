#pragma once
// Integers for the exact predicates of Boost.Polygon's Voronoi diagram. Private to the room.
//
// The outlines of insets are full of arcs: chords that touch one circle, whose centre many of them share.
// There the diagram's quick predicates fail and the exact ones decide, in products of twenty words and more.
// Boost.Polygon's own integers multiply in words of 32 bits and copy 264 bytes each time, which was most of a
// diagram's time: Boost.Multiprecision's do it in words of 64 and copy what is used.
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/polygon/detail/voronoi_ctypes.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

namespace strandline::exact {

/// At most 2048 bits: what Boost proves enough for coordinates of 32 bits.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<2048, 2048, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// As m * 2^e, m from its highest two words: at least 65 bits, of which a double holds 53.
inline std::pair<double, int> scaled(const Integer& a) {
    const auto& words = a.backend();
    constexpr int bits = 64;
    static_assert(sizeof(*words.limbs()) * 8 == bits);
    const auto n = static_cast<int>(words.size());
    const auto* low = words.limbs();
    double m = static_cast<double>(low[n - 1]);
    if (n > 1) m = std::ldexp(m, bits) + static_cast<double>(low[n - 2]);
    return {words.sign() ? -m : m, n > 2 ? (n - 2) * bits : 0};
}

struct ToDouble : boost::polygon::detail::type_converter_fpt {
    using boost::polygon::detail::type_converter_fpt::operator();
    double operator()(const Integer& a) const {
        const auto [m, e] = scaled(a);
        return std::ldexp(m, e);
    }
};

struct ToWideExponent {
    boost::polygon::detail::extended_exponent_fpt<double> operator()(const Integer& a) const {
        const auto [m, e] = scaled(a);
        return {m, e};
    }
};

/// The arithmetic of a Voronoi diagram: Boost's, but for the integers.
struct Arithmetic : boost::polygon::detail::voronoi_ctype_traits<std::int32_t> {
    using big_int_type = Integer;
    using to_fpt_converter_type = ToDouble;
    using to_efpt_converter_type = ToWideExponent;
};

}  // namespace strandline::exact
