#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace multipath {

/// Four bytes, the highest first.
inline std::string big_endian(std::uint32_t value)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>((value >> shift) & 0xffu);
    return bytes;
}

/// The number that up to four bytes stand for.
inline std::uint32_t from_big_endian(std::string_view bytes)
{
    std::uint32_t value = 0;
    for (const char c : bytes)
        value = value << 8 | static_cast<unsigned char>(c);
    return value;
}

} // namespace multipath
