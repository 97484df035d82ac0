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

/// A Uint32Array of colours with a shared exponent, in the unit in which all of them fit.
struct PackedLight
{
    double unit = 1.0; ///< a power of two
    std::string words;
};

PackedLight packed_light(const std::vector<Rgb>& values);

} // namespace multipath
