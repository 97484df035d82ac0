#pragma once

#include <array>
#include <cstdint>

namespace multipath {

/// Sobol's sequence in the order of Antonov and Saleev, with the primitive polynomials and starting direction numbers
/// of Numerical Recipes in C, 2nd edition, section 7.7. Six dimensions; indices below 2^52.
namespace sobol {

constexpr int dimensions = 6;
constexpr int index_bits = 52;

/// Direction numbers of one dimension; bit 63 stands for 1/2.
using DirectionNumbers = std::array<std::uint64_t, index_bits>;

/// Computed from the recurrence, once.
const std::array<DirectionNumbers, dimensions>& direction_numbers();

/// Coordinate of point n as a fixed-point number below 1 (bit 63 stands for 1/2). n < 2^52, 0 <= dimension < 6.
std::uint64_t coordinate_bits(std::uint64_t n, int dimension);

} // namespace sobol

} // namespace multipath
