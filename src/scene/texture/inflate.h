#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace multipath {

/// Decompresses a zlib stream (RFC 1950) whose contents must be `size` bytes; never decompresses more than that. Bytes
/// after the end of the stream are ignored. Throws ImageError if the stream is damaged or truncated, or if its contents
/// have another size.
std::vector<std::uint8_t> inflate(std::string_view stream, std::size_t size);

} // namespace multipath
