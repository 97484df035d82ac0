#pragma once

#include "image/image.h"

#include <string>

namespace multipath {

/// Bytes of a binary portable pixmap (PPM, P6). Line ends in `comment` become spaces. The file has no comment if
/// `comment` is empty.
std::string ppm_bytes(const ScreenImage& image, const std::string& comment = "");

/// Bytes of a portable float map (PFM, PF): radiosities [W/m^2] in single precision, little endian, bottom row first.
std::string pfm_bytes(const Image& image);

} // namespace multipath
