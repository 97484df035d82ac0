#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace multipath {

/// Decompresses a zlib stream (RFC 1950) whose contents must be `size` bytes; never decompresses more. Bytes after the
/// stream are ignored. Throws ImageError if the stream is damaged, truncated or of another size.
std::vector<std::uint8_t> inflate(std::string_view stream, std::size_t size);

} // namespace multipath
