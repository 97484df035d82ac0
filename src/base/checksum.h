#pragma once

#include <cstdint>
#include <string_view>

namespace multipath {

/// CRC-32 as PNG uses it (ISO 3309, reflected polynomial 0xEDB88320).
std::uint32_t crc32(std::string_view bytes);

/// Adler-32 as zlib uses it (RFC 1950).
std::uint32_t adler32(std::string_view bytes);

} // namespace multipath
