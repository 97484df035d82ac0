#pragma once

#include "image/image.h"

#include <string>

namespace multipath {

/// A PNG file, 8 bits per channel, sRGB. The comment may be empty; png_comment reads it again. What is neither
/// printable, a line feed nor well-formed UTF-8 becomes '?'.
std::string png_bytes(const ScreenImage& image, const std::string& comment = "");

} // namespace multipath
