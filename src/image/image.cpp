#include "image/image.h"

#include "base/little_endian.h"

namespace multipath {

std::string ppm_bytes(const ScreenImage& image, const std::string& comment)
{
    std::string bytes = "P6\n";
    if (!comment.empty()) {
        bytes += "# ";
        for (const char c : comment)
            bytes += c == '\n' || c == '\r' ? ' ' : c;
        bytes += '\n';
    }
    bytes += std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
    bytes.append(image.bytes.begin(), image.bytes.end());
    return bytes;
}

std::string pfm_bytes(const Image& image)
{
    // A negative scale means little endian.
    std::string bytes = "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
    bytes.reserve(bytes.size() + 12 * image.pixels.size());
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x)
            for (const double channel : {image.at(x, y).r, image.at(x, y).g, image.at(x, y).b})
                append_little_endian(bytes, static_cast<float>(channel));
    return bytes;
}

} // namespace multipath
