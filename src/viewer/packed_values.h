#pragma once

#include "scene/rgb.h"

#include <cstdint>
#include <string>
#include <vector>

// Lists of numbers as the viewer's page holds them: the little-endian bytes of a JavaScript typed array, in base64.

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
/// blue, then five of their common exponent. The error of a channel is at most about 1/512 of the brightest channel, or
/// 2^-25 if that channel is below 2^-16. Channels above largest_shared are clipped; negative ones and NaN become 0.
std::uint32_t shared_exponent(Rgb colour);

/// 511 * 2^(31 - 15 - 9): largest mantissa, largest exponent, bias of the exponent, bits of the mantissa.
constexpr double largest_shared = 65408.0;

/// A list of colours, each divided by a common `unit` and packed by shared_exponent(). A colour is `unit` times its
/// unpacked value.
struct PackedLight
{
    double unit = 1.0; ///< a power of two; 1 if no finite channel is positive
    std::string words; ///< a Uint32Array, one word per colour
};

/// Packs the colours. The unit is the smallest power of two for which no finite channel, divided by the unit, exceeds
/// largest_shared.
PackedLight packed_light(const std::vector<Rgb>& values);

} // namespace multipath
