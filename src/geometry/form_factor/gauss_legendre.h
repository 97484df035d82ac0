#pragma once

#include <array>
#include <cstddef>

namespace multipath {

// Gauss-Legendre quadrature: n nodes are exact for polynomials of degree 2 n - 1 (Abramowitz and Stegun, table 25.4).

/// A node of a quadrature rule: the integral is approximated by the sum of weight * f(place).
struct GaussNode
{
    double place; ///< abscissa
    double weight;
};

template <std::size_t n>
using GaussRule = std::array<GaussNode, n>;

/// Rules of two and three nodes on [0, 1]. Their weights are integers with the sums 2 and 18, by which the caller
/// divides. On [-1, 1] the nodes would be +-1/sqrt(3), and 0 and +-sqrt(3/5).
constexpr GaussRule<2> gauss_2 = {{{0.2113248654051871, 1.0}, {1.0 - 0.2113248654051871, 1.0}}};
constexpr GaussRule<3> gauss_3 = {{{0.1127016653792583, 5.0}, {0.5, 8.0}, {1.0 - 0.1127016653792583, 5.0}}};

/// The positive five of the ten symmetric nodes on [-1, 1]. The weights of all ten have the sum 2.
constexpr GaussRule<5> half_gauss_10 = {{{0.1488743389816312, 0.2955242247147529},
                                         {0.4333953941292472, 0.2692667193099963},
                                         {0.6794095682990244, 0.2190863625159820},
                                         {0.8650633666889845, 0.1494513491505806},
                                         {0.9739065285171717, 0.0666713443086881}}};

} // namespace multipath
