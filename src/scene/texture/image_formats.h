#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace multipath {

/// An image of 8 bits per channel, encoded in sRGB as in image files.
struct Bitmap
{
    using Colour = std::array<std::uint8_t, 3>; ///< red, green, blue

    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgb; ///< 3 * width * height bytes, row by row from the top, in each row from the left
    std::vector<std::uint8_t> alpha = {}; ///< opacity from 0 to 255 in the same order; empty: all opaque
    bool is_of_inks = false;              ///< the file holds inks (CMYK), which glTF does not allow

    /// Sets a pixel, and its opacity if the image has any.
    void set(std::uint32_t x, std::uint32_t y, Colour colour, unsigned opacity = 255)
    {
        const std::size_t pixel = std::size_t{width} * y + x;
        std::copy(colour.begin(), colour.end(), &rgb[3 * pixel]);
        if (!alpha.empty())
            alpha[pixel] = static_cast<std::uint8_t>(opacity);
    }
    /// The first pixel of row y; row 0 is at the top.
    std::uint8_t* row(std::uint32_t y) { return &rgb[std::size_t{3} * width * y]; }
    const std::uint8_t* row(std::uint32_t y) const { return &rgb[std::size_t{3} * width * y]; }
};

/// Throws ImageError for an image without pixels or with more than 2^26 pixels (8192 x 8192) or more than 2^16 in
/// a row.
void require_bitmap_size(std::uint32_t width, std::uint32_t height);

/// Returns a black image, transparent if `has_alpha`. Throws ImageError like require_bitmap_size().
Bitmap blank_bitmap(std::uint32_t width, std::uint32_t height, bool has_alpha = false);

/// Makes an image opaque all of whose pixels have opacity 0: some programs leave these bytes unused.
void drop_unused_alpha(Bitmap& bitmap);

// Decoders of image files. `bytes` is the whole contents of a file. Each decoder throws ImageError if the file is
// damaged or not supported. Colour profiles are ignored. PNG, TGA and BMP have opacity, other formats do not.

/// Portable Network Graphics (ISO/IEC 15948): all colour types, depths and interlacing.
Bitmap read_png(std::string_view bytes);
/// JPEG (ITU-T T.81): baseline, extended and progressive, Huffman coded, 8 bits, one, three or four components.
Bitmap read_jpeg(std::string_view bytes);
/// Truevision TGA, uncompressed or run-length encoded: 24 or 32 bits of colour, or grey.
Bitmap read_tga(std::string_view bytes);
/// Windows bitmap, uncompressed: a palette, or 24 or 32 bits of colour.
Bitmap read_bmp(std::string_view bytes);
/// Netpbm: the first image of a file of the types P2, P3, P5 and P6.
Bitmap read_pnm(std::string_view bytes);

/// Decodes an image in any of these formats. The format is detected from the first bytes; TGA, which has no signature,
/// from a `name` that ends in ".tga" in upper or lower case. Throws ImageError if the format is none of these.
Bitmap read_image(std::string_view name, std::string_view bytes);

} // namespace multipath
