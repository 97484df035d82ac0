#include "viewer/packed_values.h"

#include "export/base64.h"
#include "viewer/shared_exponent.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace multipath {

namespace {

void append_word(std::string& bytes, std::uint32_t word)
{
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(static_cast<unsigned char>(word >> shift & 255u));
}

void append_number(std::string& bytes, double value)
{
    const auto single = static_cast<float>(value);
    std::uint32_t word = 0;
    std::memcpy(&word, &single, sizeof word);
    append_word(bytes, word);
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
        append_word(bytes, value);
    return base64(bytes);
}

std::string packed_numbers(const std::vector<double>& values)
{
    std::string bytes;
    for (const double value : values)
        append_number(bytes, value);
    return base64(bytes);
}

std::string packed_colours(const std::vector<Rgb>& values)
{
    std::string bytes;
    for (const Rgb& value : values)
        for (const double channel : {value.r, value.g, value.b})
            append_number(bytes, channel);
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
