#pragma once

#include "base/errors.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace multipath {

/// Reads the bytes of a file in order. Functions that read throw ImageError if fewer bytes are left than they need. The
/// bytes are not copied and must outlive this object.
class ByteReader
{
public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    /// The number of bytes that are not yet read.
    std::size_t left() const { return rest_.size(); }

    /// Reads `count` bytes and returns a pointer to them, which stays valid as long as the bytes of the file.
    const std::uint8_t* bytes(std::size_t count)
    {
        if (count > rest_.size())
            throw ImageError("ends too early");
        const char* const first = rest_.data();
        rest_.remove_prefix(count);
        return reinterpret_cast<const std::uint8_t*>(first);
    }

    void skip(std::size_t count) { bytes(count); }
    std::uint8_t byte() { return *bytes(1); }

    std::uint32_t little_endian_16()
    {
        const std::uint8_t* const b = bytes(2);
        return b[0] | std::uint32_t{b[1]} << 8;
    }

    std::uint32_t little_endian_32()
    {
        const std::uint32_t low = little_endian_16();
        return low | little_endian_16() << 16;
    }

    std::uint32_t big_endian_16()
    {
        const std::uint8_t* const b = bytes(2);
        return std::uint32_t{b[0]} << 8 | b[1];
    }

    std::uint32_t big_endian_32()
    {
        const std::uint32_t high = big_endian_16();
        return high << 16 | big_endian_16();
    }

private:
    std::string_view rest_;
};

/// The number `i` of a row of numbers of 1, 2, 4 or 8 bits, which begin at the highest bits of each byte.
inline unsigned packed_number(const std::uint8_t* row, std::size_t i, unsigned bits)
{
    const std::size_t bit = i * bits;
    return static_cast<unsigned>(row[bit / 8]) >> (8 - bits - bit % 8) & ((1u << bits) - 1);
}

/// Decompresses a zlib stream (RFC 1950) whose contents must be `size` bytes; never decompresses more than that. Bytes
/// after the end of the stream are ignored. Throws ImageError if the stream is damaged or truncated, or if its contents
/// have another size.
std::vector<std::uint8_t> inflate(std::string_view stream, std::size_t size);

} // namespace multipath
