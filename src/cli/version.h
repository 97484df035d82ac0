#pragma once

#include <string>

namespace multipath {

/// "multipath 0.1.0"
std::string version();

/// Version, compiler and what the program was built for, a few lines.
std::string version_text();

} // namespace multipath
