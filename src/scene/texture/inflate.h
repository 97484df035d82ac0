#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace multipath {

/// The contents of a zlib stream (RFC 1950), which must be `size` bytes; no more are ever unpacked. What follows the
/// stream is ignored. Throws ImageError for a stream that is damaged, cut off or of another size.
std::vector<std::uint8_t> inflate(std::string_view stream, std::size_t size);

} // namespace multipath
