#pragma once

#include "image/image.h"

#include <string>

namespace multipath {

/// A PNG file, 8 bits per channel, sRGB. The comment (kept as a tEXt chunk) may be empty; what is not ASCII
/// becomes '?'.
std::string png_bytes(const ScreenImage& image, const std::string& comment = "");

} // namespace multipath
