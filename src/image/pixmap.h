#pragma once

#include "image/image.h"

#include <string>

namespace multipath {

/// A binary portable pixmap (P6). The comment may be empty; line ends in it become blanks.
std::string ppm_bytes(const ScreenImage& image, const std::string& comment = "");

/// A portable float map (PF): linear values in single precision, little endian, rows from the bottom.
std::string pfm_bytes(const Image& image);

} // namespace multipath
