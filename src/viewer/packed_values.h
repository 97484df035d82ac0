#pragma once

#include "scene/rgb.h"

#include <cstdint>
#include <string>
#include <vector>

// Lists of numbers as they stand in the page: base64 of what a typed array of JavaScript holds, lowest byte first.

namespace multipath {

/// A Uint8Array.
std::string packed_bytes(const std::vector<std::uint8_t>& values);

/// A Uint32Array.
std::string packed_counts(const std::vector<std::uint32_t>& values);

/// A Float32Array.
std::string packed_numbers(const std::vector<double>& values);

/// A Float32Array with three numbers for each.
std::string packed_colours(const std::vector<Rgb>& values);

/// The colour in 32 bits: nine bits of red, green and blue from the lowest up, then five of an exponent that they
/// share. The format RGB9_E5 of WebGL 2. A channel is right to 1/512 of the brightest one of its colour; colours above
/// largest_shared are clipped, negative channels and what is not a number become 0.
std::uint32_t shared_exponent(Rgb colour);

constexpr double largest_shared = 65408.0; ///< 511 * 2^(31 - 15 - 9)

/// A Uint32Array of colours with a shared exponent, in the unit in which all of them fit.
struct PackedLight
{
    double unit = 1.0; ///< a power of two
    std::string words;
};

PackedLight packed_light(const std::vector<Rgb>& values);

} // namespace multipath
