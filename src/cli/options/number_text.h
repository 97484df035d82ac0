#pragma once

#include "geometry/vec3.h"

#include <cstdint>
#include <limits>
#include <string_view>

// Numbers as users write them: 1000000, 1e6, 1M (k, M, G are powers of 1000), 2^20. All functions throw UsageError for
// anything else: signs where they make no sense, nan, inf, trailing text, decimal commas, overflow. The message begins
// with `option` ("--lines").

namespace multipath {

constexpr std::uint64_t largest_count = std::uint64_t(1) << 63;

/// A whole number within [low, high], exact up to 2^63 in digits and as a power of two. Throws UsageError for a number
/// outside.
std::uint64_t read_count(std::string_view option, std::string_view text, std::uint64_t low = 0,
                         std::uint64_t high = largest_count);

/// A number within [low, high]; only a negative `low` allows negative numbers. Throws UsageError for a number outside.
double read_real(std::string_view option, std::string_view text, double low = 0.0,
                 double high = std::numeric_limits<double>::max());

/// A real number above zero.
double read_positive(std::string_view option, std::string_view text);

/// A share within [0, 1]: `1%` or `0.01`. A bare `1` is refused: it could mean 1 % or everything.
double read_share(std::string_view option, std::string_view text);

/// [bytes] A size, rounded down, 1 to 2^63: 512MB, 2GB, 1GiB, or a plain number of bytes; upper or lower case, the B
/// optional. MB is 10^6 bytes, MiB 2^20 bytes.
std::uint64_t read_bytes(std::string_view option, std::string_view text);

/// [s] A time above zero: 30s, 5m, 2h, 250ms, or a plain number of seconds.
double read_seconds(std::string_view option, std::string_view text);

/// Three finite numbers of any sign: 1,2.5,-3.
Vec3 read_vec3(std::string_view option, std::string_view text);

/// A direction: three numbers, not all zero. It is scaled by a power of two so that the largest absolute component is
/// in [1, 2), and the square of the length neither overflows nor vanishes.
Vec3 read_direction(std::string_view option, std::string_view text);

/// Size of a picture [pixels].
struct PixelSize
{
    int width = 0;
    int height = 0;
};

/// Width and height, 1 to `largest` each: 800x600.
PixelSize read_pixel_size(std::string_view option, std::string_view text, int largest);

} // namespace multipath
