#pragma once
// Private to this room: Gauss-Legendre quadrature with 10 nodes, exact for polynomials of degree 19.
#include <array>

namespace strandline::quadrature {

/// Nodes and weights on [-1, 1]; each stands for its mirror image too (Abramowitz and Stegun, table 25.4).
struct Node {
    double at, weight;
};
inline constexpr std::array<Node, 5> nodes{{{0.14887433898163122, 0.29552422471475287},
                                            {0.43339539412924719, 0.26926671930999635},
                                            {0.67940956829902441, 0.21908636251598204},
                                            {0.86506336668898451, 0.14945134915058059},
                                            {0.97390652851717172, 0.06667134430868814}}};

/// Calls add(s, weight) for the nodes of one panel [from, to]; the weights sum to its length.
template <class Add>
void panel(double from, double to, Add add) {
    const double middle = (from + to) / 2, half = (to - from) / 2;
    for (const Node& node : nodes) {
        add(middle - half * node.at, half * node.weight);
        add(middle + half * node.at, half * node.weight);
    }
}

}  // namespace strandline::quadrature
