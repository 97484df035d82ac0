#pragma once

#include <string>
#include <sys/types.h>

namespace multipath {

/// A temporary output file, to be renamed to its target NAME once it is complete: ".NAME.XXXXXX.part" in the folder of
/// the target, with at most 200 bytes of NAME. The file is locked (flock) while its descriptor is open.
struct PartFile
{
    std::string path;
    int descriptor = -1; ///< open for writing; -1: the file could not be created, see errno
};

/// Creates an empty part file with these permissions. First removes abandoned part files of the same target: killed
/// runs have left them, and nobody locks them any more.
PartFile create_part_file(const std::string& target, mode_t mode);

/// The folder of a path, including the last slash; "" for the working directory.
std::string folder_of(const std::string& path);

/// Registers a part file with the signal handlers, since a signal ends the program without running destructors. While
/// the object exists, remove_unfinished() removes the file. At most 64 files with paths below 4096 bytes can be
/// registered at a time; a signal leaves other files for the next run to remove.
class Unfinished
{
public:
    Unfinished() = default; ///< registers nothing
    /// `target`: the name that the file will get.
    Unfinished(const std::string& path, const std::string& target);
    ~Unfinished() { forget(); }
    Unfinished(Unfinished&& other) noexcept;
    Unfinished& operator=(Unfinished&& other) noexcept;

    /// Marks the file as complete: only the rename is left.
    void complete() noexcept;

private:
    void forget() noexcept;

    static constexpr int none = -1;

    int slot_ = none;
};

/// Removes all registered files, complete or not. Async-signal-safe.
void remove_unfinished() noexcept;

/// Renames the complete files to their targets and removes the others. Calls `not_written` with the target of each file
/// that was not renamed. Async-signal-safe.
void settle_unfinished(void (*not_written)(const char* target)) noexcept;

} // namespace multipath
