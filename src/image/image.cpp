#include "image/image.h"

#include "base/little_endian.h"
#include "base/text_format.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

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

std::string hdr_bytes(const Image& image, const std::string& comment)
{
    std::string bytes = "#?RADIANCE\n" + (comment.empty() ? "" : "# " + without_controls(comment) + "\n") +
                        "FORMAT=32-bit_rle_rgbe\nEXPOSURE=3.14159265\n\n-Y " + std::to_string(image.height) + " +X " +
                        std::to_string(image.width) + "\n";
    for (const Rgb& pixel : image.pixels) {
        int exponent = 0;
        std::frexp(std::max({pixel.r, pixel.g, pixel.b}), &exponent);
        const bool is_black = !(std::max({pixel.r, pixel.g, pixel.b}) > 0.0) || exponent < -127;
        for (const double channel : {pixel.r, pixel.g, pixel.b})
            bytes += static_cast<char>(
                static_cast<int>(is_black ? 0.0 : std::clamp(std::ldexp(channel, 8 - exponent), 0.0, 255.0)));
        bytes += static_cast<char>(is_black ? 0 : std::min(exponent + 128, 255));
    }
    return bytes;
}

namespace {

/// The bits of the nearest half float (IEEE 754 binary16) of at most 65504 in magnitude.
std::uint32_t half_bits(double value)
{
    int exponent = 0; // magnitude = m * 2^exponent, m in [0.5, 1)
    const double magnitude = std::abs(value);
    std::frexp(std::max(magnitude, 0x1p-24), &exponent);
    exponent = std::clamp(exponent, -13, 17); // below 2^-14 all steps are 2^-24
    const double steps = std::nearbyint(std::ldexp(magnitude, 11 - exponent));
    const double bits = std::min((exponent + 13) * 1024.0 + steps, double{0x7bff});
    return static_cast<std::uint32_t>(bits) | (value < 0.0 ? 0x8000u : 0u);
}

} // namespace

std::string exr_bytes(const Image& image, const std::string& comment)
{
    std::string bytes;
    const auto number = [&bytes](auto value) { append_little_endian(bytes, value); };
    const auto text = [&bytes](const char* name) { bytes.append(name, std::strlen(name) + 1); };
    const auto attribute = [&](const char* name, const char* type, std::size_t size) {
        text(name);
        text(type);
        number(static_cast<std::uint32_t>(size));
    };
    const auto width = static_cast<std::uint32_t>(image.width);
    const auto height = static_cast<std::uint32_t>(image.height);
    number(20000630u); // magic
    number(2u);        // version
    attribute("channels", "chlist", 3 * 18 + 1);
    for (const char* name : {"B", "G", "R"}) { // in alphabetical order
        text(name);
        for (const std::uint32_t half_linear_sampling : {1u, 0u, 1u, 1u})
            number(half_linear_sampling);
    }
    bytes += '\0';
    attribute("compression", "compression", 1);
    bytes += '\0';
    for (const char* window : {"dataWindow", "displayWindow"}) {
        attribute(window, "box2i", 16);
        for (const std::uint32_t corner : {0u, 0u, width - 1, height - 1})
            number(corner);
    }
    attribute("lineOrder", "lineOrder", 1);
    bytes += '\0';
    attribute("pixelAspectRatio", "float", 4);
    number(1.0f);
    attribute("screenWindowCenter", "v2f", 8);
    number(0.0f);
    number(0.0f);
    attribute("screenWindowWidth", "float", 4);
    number(1.0f);
    if (!comment.empty()) {
        attribute("comments", "string", comment.size());
        bytes += comment;
    }
    bytes += '\0';
    const std::size_t row_size = 8 + std::size_t{6} * width;
    const std::size_t first_row = bytes.size() + std::size_t{8} * height;
    for (std::size_t y = 0; y < height; ++y)
        for (const unsigned shift : {0u, 32u})
            number(static_cast<std::uint32_t>(std::uint64_t{first_row + y * row_size} >> shift));
    for (std::uint32_t y = 0; y < height; ++y) {
        number(y);
        number(6 * width);
        for (const auto channel : {&Rgb::b, &Rgb::g, &Rgb::r})
            for (std::uint32_t x = 0; x < width; ++x) {
                const std::uint32_t bits = half_bits(image.pixels[std::size_t{y} * width + x].*channel);
                bytes += static_cast<char>(bits & 0xffu);
                bytes += static_cast<char>(bits >> 8);
            }
    }
    return bytes;
}

} // namespace multipath
