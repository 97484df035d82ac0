#pragma once

#include <string>

namespace multipath {

/// The bytes compressed as a deflate stream (RFC 1951).
std::string deflate(const std::string& bytes);

/// The bytes compressed as a zlib stream (RFC 1950): header, deflate stream, Adler-32.
std::string zlib_bytes(const std::string& bytes);

} // namespace multipath
