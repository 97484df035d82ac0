#pragma once

#include "image/image.h"

#include <string>

namespace multipath {

/// A portable float map (PF): linear values in single precision, little endian, rows from the bottom.
std::string pfm_bytes(const Image& image);

} // namespace multipath
