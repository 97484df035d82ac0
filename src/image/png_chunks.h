#pragma once

#include <string_view>
#include <vector>

namespace multipath {

/// A part of a PNG file. Both views refer to the file's bytes.
struct PngChunk
{
    std::string_view type; ///< "IHDR", "tEXt", ...
    std::string_view data;
};

bool is_png(std::string_view bytes);

/// The chunks in the file's order, as far as they are whole; none for what is no PNG. Checksums are not looked at.
std::vector<PngChunk> png_chunks(std::string_view bytes);

} // namespace multipath
