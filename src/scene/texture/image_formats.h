#pragma once

#include "scene/texture/bitmap.h"

#include <string_view>

namespace multipath {

// Decoders of image files, given by all their bytes. Each throws ImageError if the file is damaged or not supported.
// Transparency and colour profiles are ignored.

/// Portable Network Graphics (ISO/IEC 15948): all colour types, depths and interlacing.
Bitmap read_png(std::string_view bytes);
/// JPEG (ITU-T T.81): baseline, extended and progressive, Huffman coded, 8 bits, one, three or four components.
Bitmap read_jpeg(std::string_view bytes);
/// Truevision TGA, uncompressed or run-length encoded.
Bitmap read_tga(std::string_view bytes);
/// Windows bitmap, uncompressed or run-length encoded.
Bitmap read_bmp(std::string_view bytes);
/// Netpbm: P1 to P6.
Bitmap read_pnm(std::string_view bytes);

/// Detects the format from the first bytes; TGA, which has no signature, from a `name` that ends in ".tga".
Bitmap read_image(std::string_view name, std::string_view bytes);

} // namespace multipath
