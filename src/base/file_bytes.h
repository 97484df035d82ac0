#pragma once

#include <string>

namespace multipath {

/// The bytes of a file, or of a pipe up to its end. Throws InputError if it cannot be read, is a device, or is a pipe
/// that gives more than 1 GiB, with a message such as "room.csv: cannot be read: Permission denied".
std::string bytes_of_file(const std::string& path);

} // namespace multipath
