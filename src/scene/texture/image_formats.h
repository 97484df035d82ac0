#pragma once

#include "scene/texture/bitmap.h"

#include <string_view>

namespace multipath {

// Readers of the bytes of whole files; each throws ImageError for what is damaged or not supported. Transparency and
// colour profiles are ignored.

/// Portable Network Graphics (ISO/IEC 15948): all colour types, depths and interlacing.
Bitmap read_png(std::string_view bytes);
/// JPEG (ITU-T T.81), baseline, extended and progressive, Huffman coded, 8 bits, of one, three or four components.
Bitmap read_jpeg(std::string_view bytes);
/// Truevision TGA, plain and run-length encoded.
Bitmap read_tga(std::string_view bytes);
/// Windows bitmap, plain and run-length encoded.
Bitmap read_bmp(std::string_view bytes);
/// Netpbm: P1 to P6.
Bitmap read_pnm(std::string_view bytes);

/// Whichever of these the bytes begin like; TGA, which has no mark of its own, where `name` ends in ".tga".
Bitmap read_image(std::string_view name, std::string_view bytes);

} // namespace multipath
