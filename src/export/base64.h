#pragma once

#include <string>

namespace multipath {

/// Bytes as text (RFC 4648), for pictures inside of a page.
std::string base64(const std::string& bytes);

} // namespace multipath
