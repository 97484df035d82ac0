#pragma once

#include "scene/texture/bitmap.h"

#include <string_view>

namespace multipath {

// Decoders of image files. `bytes` is the whole contents of a file. Each decoder throws ImageError if the file is
// damaged or not supported. Transparency and colour profiles are ignored.

/// Portable Network Graphics (ISO/IEC 15948): all colour types, depths and interlacing.
Bitmap read_png(std::string_view bytes);
/// JPEG (ITU-T T.81): baseline, extended and progressive, Huffman coded, 8 bits, one, three or four components. A file
/// that breaks off in its pixels is decoded up to there; the rest is grey.
Bitmap read_jpeg(std::string_view bytes);
/// Truevision TGA, uncompressed or run-length encoded: palette, 15 to 32 bits of colour, or grey.
Bitmap read_tga(std::string_view bytes);
/// Windows bitmap of 1 to 32 bits per pixel, uncompressed or run-length encoded.
Bitmap read_bmp(std::string_view bytes);
/// Netpbm: the first image of a file of the types P1 to P6.
Bitmap read_pnm(std::string_view bytes);

/// Decodes an image in any of these formats. The format is detected from the first bytes; TGA, which has no signature,
/// from a `name` that ends in ".tga" in upper or lower case. Throws ImageError if the format is none of these.
Bitmap read_image(std::string_view name, std::string_view bytes);

} // namespace multipath
