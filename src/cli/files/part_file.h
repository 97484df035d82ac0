#pragma once

#include <string>
#include <sys/types.h>

namespace multipath {

/// An output that is not complete yet: ".NAME.XXXXXX.part" in the folder of the file that it will become, and locked
/// (flock) for as long as its descriptor is open.
struct PartFile
{
    std::string path;
    int descriptor = -1; ///< for writing; -1: not created, errno says why
};

/// A new, empty one. Those that killed runs have left for the same target, locked by nobody, are removed first.
PartFile create_part_file(const std::string& target, mode_t mode);

/// The folder's part of a path, up to and with the last slash; "" for the working directory.
std::string folder_of(const std::string& path);

} // namespace multipath
