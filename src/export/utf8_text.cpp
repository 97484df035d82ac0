#include "export/utf8_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace multipath {

namespace {

/// Bytes of the character at the start of the text, 0 where none begins there: not a lead byte, cut off, longer than it
/// need be, a half of a UTF-16 pair, or beyond U+10FFFF.
std::size_t character_length(std::string_view text)
{
    const auto byte = [&](std::size_t n) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[n])); };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80)
        return 1;
    const std::size_t length = lead < 0xc0 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf8 ? 4 : 0;
    if (length == 0 || length > text.size())
        return 0;
    std::uint32_t code = lead & (0x7fu >> length);
    for (std::size_t n = 1; n < length; ++n) {
        if ((byte(n) & 0xc0u) != 0x80)
            return 0;
        code = code << 6 | (byte(n) & 0x3fu);
    }
    constexpr std::array<std::uint32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
    const bool half_of_pair = code >= 0xd800 && code < 0xe000;
    return code < smallest[length] || half_of_pair || code > 0x10ffff ? 0 : length;
}

} // namespace

std::string utf8_text(std::string_view bytes)
{
    std::string text;
    while (!bytes.empty()) {
        const std::size_t length = character_length(bytes);
        if (length == 0) {
            const auto latin = static_cast<unsigned char>(bytes[0]);
            text += static_cast<char>(0xc0 | latin >> 6);
            text += static_cast<char>(0x80 | (latin & 0x3f));
        } else {
            text += bytes.substr(0, length);
        }
        bytes.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return text;
}

} // namespace multipath
