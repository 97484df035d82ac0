#pragma once

#include <string>

namespace multipath {

/// "multipath 0.1.0"
std::string version();

/// The checksum and size of the sources that the program was built from, which tells apart programs of one version.
std::string sources_checksum();

/// Version, compiler and what the program was built for, a few lines.
std::string version_text();

} // namespace multipath
