#include "image/png_chunks.h"

#include "image/big_endian.h"

#include <utility>

namespace multipath {

namespace {

constexpr std::size_t frame_size = 12; ///< length, type and checksum [byte]

} // namespace

bool is_png(std::string_view bytes)
{
    return bytes.substr(0, png_signature.size()) == png_signature;
}

std::vector<PngChunk> png_chunks(std::string_view bytes)
{
    std::vector<PngChunk> chunks;
    if (!is_png(bytes))
        return chunks;
    bytes.remove_prefix(png_signature.size());
    while (bytes.size() >= frame_size) {
        const std::size_t size = from_big_endian(bytes.substr(0, 4));
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
