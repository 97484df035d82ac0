#pragma once

#include "scene/rgb.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Index of a pixel in a picture that is stored row by row from the top left.
inline std::size_t pixel_index(int width, int x, int y)
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

/// A picture in linear light: radiosity [W/m^2] per pixel, row by row from the top left.
struct Image
{
    int width = 0;
    int height = 0;
    std::vector<Rgb> pixels;

    const Rgb& at(int x, int y) const { return pixels[pixel_index(width, x, y)]; }
    Rgb& at(int x, int y) { return pixels[pixel_index(width, x, y)]; }
};

/// A picture for the screen: sRGB, one byte each for red, green and blue per pixel, row by row from the top left.
struct ScreenImage
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> bytes; ///< red, green and blue of each pixel: 3 * width * height bytes

    std::uint8_t* at(int x, int y) { return &bytes[3 * pixel_index(width, x, y)]; } ///< the three bytes of a pixel
};

/// Bytes of a binary portable pixmap (PPM, P6). Line ends in `comment` become spaces. The file has no comment if
/// `comment` is empty.
std::string ppm_bytes(const ScreenImage& image, const std::string& comment = "");

/// Bytes of a portable float map (PFM, PF): radiosities [W/m^2] in single precision, little endian, bottom row first.
std::string pfm_bytes(const Image& image);

/// Bytes of a Radiance picture (RGBE, not run-length encoded): 8 bits for each channel with a common exponent, that is
/// 0.4 % of the largest. EXPOSURE tells readers of radiances that the values are radiosities [W/m^2], pi times as
/// large. Control characters in `comment` become spaces.
std::string hdr_bytes(const Image& image, const std::string& comment = "");

/// Bytes of an OpenEXR picture (version 2, scan lines, not compressed): radiosities [W/m^2] as half floats, of at most
/// 65504. `comment` becomes the attribute `comments`, unless it is empty.
std::string exr_bytes(const Image& image, const std::string& comment = "");

} // namespace multipath
