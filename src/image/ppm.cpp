#include "image/ppm.h"

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

} // namespace multipath
