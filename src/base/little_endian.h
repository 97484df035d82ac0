#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace multipath {

/// Appends the four bytes of a number, the lowest byte first, on every machine.
inline void append_little_endian(std::string& bytes, std::uint32_t value)
{
    const char four[4] = {static_cast<char>(value & 0xffu), static_cast<char>(value >> 8 & 0xffu),
                          static_cast<char>(value >> 16 & 0xffu), static_cast<char>(value >> 24)};
    bytes.append(four, 4);
}

/// Appends the four bytes of a number in single precision (IEEE 754), the lowest byte first.
inline void append_little_endian(std::string& bytes, float value)
{
    std::uint32_t bits = 0;
    static_assert(sizeof bits == sizeof value, "binary files need 32-bit floats");
    std::memcpy(&bits, &value, sizeof bits);
    append_little_endian(bytes, bits);
}

} // namespace multipath
