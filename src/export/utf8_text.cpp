#include "export/utf8_text.h"

#include "scene/utf8.h"

#include <algorithm>
#include <cstddef>

namespace multipath {

std::string utf8_text(std::string_view bytes)
{
    std::string text;
    while (!bytes.empty()) {
        const std::size_t length = utf8_character_size(bytes);
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
