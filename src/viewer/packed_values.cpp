#include "viewer/packed_values.h"

#include "export/base64.h"
#include "scene/little_endian.h"
#include "viewer/shared_exponent.h"

#include <algorithm>
#include <cmath>

namespace multipath {

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

PackedLight packed_light(const std::vector<Rgb>& values)
{
    double brightest = 0.0;
    for (const Rgb& value : values)
        for (const double channel : {value.r, value.g, value.b})
            if (std::isfinite(channel))
                brightest = std::max(brightest, channel);
    PackedLight packed;
    if (brightest > 0.0)
        packed.unit = std::exp2(std::ceil(std::log2(brightest / largest_shared)));
    std::vector<std::uint32_t> words;
    words.reserve(values.size());
    for (const Rgb& value : values)
        words.push_back(shared_exponent((1.0 / packed.unit) * value));
    packed.words = packed_counts(words);
    return packed;
}

} // namespace multipath
