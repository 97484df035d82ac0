#pragma once

#include <cstdint>
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

/// The chunks in the file's order. Checksums are not looked at.
inline std::vector<PngChunk> png_chunks(std::string_view bytes)
{
    constexpr std::size_t signature_size = 8;
    constexpr std::size_t frame_size = 12; // length, type and checksum
    std::vector<PngChunk> chunks;
    for (bytes.remove_prefix(signature_size); bytes.size() >= frame_size;) {
        std::size_t size = 0;
        for (const char digit : bytes.substr(0, 4))
            size = size << 8 | static_cast<std::uint8_t>(digit);
        chunks.push_back({bytes.substr(4, 4), bytes.substr(8, size)});
        bytes.remove_prefix(frame_size + size);
    }
    return chunks;
}

/// The text of a comment (ISO/IEC 15948, 11.3.4.3 and 11.3.4.5).
inline std::optional<std::string_view> png_comment(std::string_view bytes)
{
    for (const PngChunk& chunk : png_chunks(bytes)) {
        if (chunk.type == "tEXt")
            return chunk.data.substr(std::string_view("Comment").size() + 1);
        if (chunk.type == "iTXt")
            return chunk.data.substr(std::string_view("Comment").size() + 5);
    }
    return std::nullopt;
}

} // namespace multipath
