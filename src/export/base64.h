#pragma once

#include <string>

namespace multipath {

/// Bytes as text (RFC 4648), for what a page holds inside.
std::string base64(const std::string& bytes);

} // namespace multipath
