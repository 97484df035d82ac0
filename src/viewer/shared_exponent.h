#pragma once

#include "scene/rgb.h"

#include <cstdint>

namespace multipath {

/// The colour in 32 bits: nine bits of red, green and blue from the lowest up, then five of an exponent that they
/// share. WebGL 2 knows it as RGB9_E5. A channel is right to 1/512 of the brightest one of its colour; colours above
/// largest_shared are clipped, negative channels and what is not a number become 0.
std::uint32_t shared_exponent(Rgb colour);

constexpr double largest_shared = 65408.0; ///< 511 * 2^(31 - 15 - 9)

} // namespace multipath
