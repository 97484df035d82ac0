#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace multipath {

/// An image of 8 bits per channel, encoded in sRGB as in image files.
struct Bitmap
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgb; ///< 3 * width * height bytes, row by row from the top, in each row from the left

    /// The first pixel of row y; row 0 is at the top.
    std::uint8_t* row(std::uint32_t y) { return &rgb[std::size_t{3} * width * y]; }
    const std::uint8_t* row(std::uint32_t y) const { return &rgb[std::size_t{3} * width * y]; }
};

/// An error in an image file. The message does not name the file: it is a predicate of which the file is the subject
/// ("ends too early"), or a sentence of its own ("12 bits per pixel are not supported").
class ImageError : public std::runtime_error
{
public:
    explicit ImageError(const std::string& message) : std::runtime_error(message) {}
};

/// Throws ImageError for an image without pixels or with more than 2^26 pixels (8192 x 8192).
void require_bitmap_size(std::uint32_t width, std::uint32_t height);

/// Returns a black image. Throws ImageError like require_bitmap_size().
Bitmap blank_bitmap(std::uint32_t width, std::uint32_t height);

} // namespace multipath
