#include "viewer/packed_values.h"

#include "export/html_text.h"
#include "geometry/elementary.h"
#include "scene/little_endian.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr int mantissa_bits = 9;
constexpr int exponent_bias = 15;
constexpr int most_mantissa = 511;

double clipped(double channel)
{
    return channel > 0.0 ? std::min(channel, largest_shared) : 0.0; // 0 for NaN
}

} // namespace

std::string packed_bytes(const std::vector<std::uint8_t>& values)
{
    std::string bytes;
    for (const std::uint8_t value : values)
        bytes += static_cast<char>(value);
    return base64(bytes);
}

std::string packed_counts(const std::vector<std::uint32_t>& values)
{
    std::string bytes;
    for (const std::uint32_t value : values)
        append_little_endian(bytes, value);
    return base64(bytes);
}

std::string packed_numbers(const std::vector<double>& values)
{
    std::string bytes;
    for (const double value : values)
        append_little_endian(bytes, static_cast<float>(value));
    return base64(bytes);
}

std::string packed_colours(const std::vector<Rgb>& values)
{
    std::string bytes;
    for (const Rgb& value : values)
        for (const double channel : {value.r, value.g, value.b})
            append_little_endian(bytes, static_cast<float>(channel));
    return base64(bytes);
}

std::uint32_t shared_exponent(Rgb colour)
{
    const Rgb c = {clipped(colour.r), clipped(colour.g), clipped(colour.b)};
    const double brightest = std::max({c.r, c.g, c.b});
    int exponent = 0;
    if (brightest > 0.0) {
        int magnitude = 0;
        std::frexp(brightest, &magnitude); // brightest < 2^magnitude
        exponent = std::max(0, magnitude + exponent_bias);
    }
    // Rounding may carry into a tenth bit of the mantissa.
    if (std::lround(std::ldexp(brightest, mantissa_bits + exponent_bias - exponent)) > most_mantissa)
        ++exponent;
    const auto mantissa = [&](double channel) {
        return static_cast<std::uint32_t>(std::lround(std::ldexp(channel, mantissa_bits + exponent_bias - exponent)));
    };
    return mantissa(c.r) | mantissa(c.g) << 9 | mantissa(c.b) << 18 | static_cast<std::uint32_t>(exponent) << 27;
}

PackedLight packed_light(const std::vector<Rgb>& values)
{
    double brightest = 0.0;
    for (const Rgb& value : values)
        for (const double channel : {value.r, value.g, value.b})
            if (std::isfinite(channel))
                brightest = std::max(brightest, channel);
    PackedLight packed;
    if (brightest > 0.0)
        packed.unit = elementary::exp2(std::ceil(elementary::log2(brightest / largest_shared)));
    std::vector<std::uint32_t> words;
    words.reserve(values.size());
    for (const Rgb& value : values)
        words.push_back(shared_exponent((1.0 / packed.unit) * value));
    packed.words = packed_counts(words);
    return packed;
}

} // namespace multipath
