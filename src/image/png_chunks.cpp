#include "image/png_chunks.h"

#include <cstdint>
#include <utility>

namespace multipath {

namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t frame_size = 12; ///< length, type and checksum [byte]

std::uint32_t big_endian(std::string_view bytes)
{
    std::uint32_t value = 0;
    for (const char c : bytes)
        value = value << 8 | static_cast<unsigned char>(c);
    return value;
}

} // namespace

bool is_png(std::string_view bytes)
{
    return bytes.substr(0, signature.size()) == signature;
}

std::vector<PngChunk> png_chunks(std::string_view bytes)
{
    std::vector<PngChunk> chunks;
    if (!is_png(bytes))
        return chunks;
    bytes.remove_prefix(signature.size());
    while (bytes.size() >= frame_size) {
        const std::size_t size = big_endian(bytes.substr(0, 4));
        if (size > bytes.size() - frame_size)
            return chunks;
        chunks.push_back({bytes.substr(4, 4), bytes.substr(8, size)});
        bytes.remove_prefix(frame_size + size);
    }
    return chunks;
}

std::optional<std::string_view> png_comment(std::string_view bytes)
{
    for (const PngChunk& chunk : png_chunks(bytes))
        for (const auto& [type, start] : {std::pair{"tEXt", plain_comment}, std::pair{"iTXt", utf8_comment}})
            if (chunk.type == type && chunk.data.substr(0, start.size()) == start)
                return chunk.data.substr(start.size());
    return std::nullopt;
}

} // namespace multipath
