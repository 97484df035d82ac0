#pragma once

#include "scene/rgb.h"

#include <cstdint>
#include <string>
#include <vector>

// Lists of numbers as the page holds them: the bytes of a typed array of JavaScript (little-endian) in base64.

namespace multipath {

/// A Uint8Array.
std::string packed_bytes(const std::vector<std::uint8_t>& values);

/// A Uint32Array.
std::string packed_counts(const std::vector<std::uint32_t>& values);

/// A Float32Array.
std::string packed_numbers(const std::vector<double>& values);

/// A Float32Array with three numbers for each colour.
std::string packed_colours(const std::vector<Rgb>& values);

/// Packs a colour into 32 bits, the format RGB9_E5 of WebGL 2: from the lowest bit, nine bits each of red, green and
/// blue, then five of their common exponent. The error of a channel is at most 1/512 of the brightest channel. Channels
/// above largest_shared are clipped; negative ones and NaN become 0.
std::uint32_t shared_exponent(Rgb colour);

constexpr double largest_shared = 65408.0; ///< 511 * 2^(31 - 15 - 9)

/// A Uint32Array of colours with a shared exponent, in a unit in which all of them are below largest_shared.
struct PackedLight
{
    double unit = 1.0; ///< a power of two
    std::string words;
};

/// Packs the colours in the smallest such unit.
PackedLight packed_light(const std::vector<Rgb>& values);

} // namespace multipath
