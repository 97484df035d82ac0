#pragma once

#include <filesystem>
#include <string>

namespace multipath {

/// The path of a file with this name in UTF-8. On Windows, bytes that are no UTF-8 are taken for Latin-1 characters;
/// what std::filesystem makes of a name there depends on the C library.
std::filesystem::path path_of(const std::string& name);

/// The bytes of a file, or of a pipe up to its end. Throws InputError if it cannot be read, is a device, or is a pipe
/// that gives more than 1 GiB, with a message such as "room.csv: cannot be read: Permission denied".
std::string bytes_of_file(const std::string& path);

} // namespace multipath
