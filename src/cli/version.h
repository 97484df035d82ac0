#pragma once

#include <string>

namespace multipath {

/// "multipath 1.0.0"
std::string version();

/// Checksum and size of the sources from which the program was built, to distinguish builds of the same version.
std::string sources_checksum();

/// Version, compiler and usable instruction sets, a line each.
std::string version_text();

} // namespace multipath
