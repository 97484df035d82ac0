#include "image/pfm.h"

#include <cstdint>
#include <cstring>

namespace multipath {

namespace {

void append_little_endian(std::string& bytes, float value)
{
    std::uint32_t bits = 0;
    static_assert(sizeof bits == sizeof value, "PFM needs 32-bit floats");
    std::memcpy(&bits, &value, sizeof bits);
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>((bits >> shift) & 0xffu);
}

} // namespace

std::string pfm_bytes(const Image& image)
{
    // The sign of the scale says little endian.
    std::string bytes = "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
    bytes.reserve(bytes.size() + 12 * image.pixels.size());
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x)
            for (const double channel : {image.at(x, y).r, image.at(x, y).g, image.at(x, y).b})
                append_little_endian(bytes, static_cast<float>(channel));
    return bytes;
}

} // namespace multipath
