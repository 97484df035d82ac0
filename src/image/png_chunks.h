#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace multipath {

/// A part of a PNG file. Both views refer to the file's bytes.
struct PngChunk
{
    std::string_view type; ///< "IHDR", "tEXt", ...
    std::string_view data;
};

/// How a PNG file begins.
constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

bool is_png(std::string_view bytes);

/// The chunks in the file's order, as far as they are whole; none for what is no PNG. Checksums are not looked at.
std::vector<PngChunk> png_chunks(std::string_view bytes);

/// How the data of a comment's chunk begin, before the text: keyword and, for UTF-8 (iTXt), that nothing is compressed
/// or translated.
constexpr std::string_view plain_comment("Comment\0", 8);
constexpr std::string_view utf8_comment("Comment\0\0\0\0\0", 12);

/// The comment that png_bytes has put into a file; none if there is none.
std::optional<std::string_view> png_comment(std::string_view bytes);

} // namespace multipath
