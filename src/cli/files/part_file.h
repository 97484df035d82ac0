#pragma once

#include <string>
#include <sys/types.h>

namespace multipath {

/// A temporary output file: ".NAME.XXXXXX.part" in the folder of its target, locked (flock) while its descriptor is
/// open.
struct PartFile
{
    std::string path;
    int descriptor = -1; ///< for writing; -1: not created, see errno
};

/// Creates an empty part file. First removes abandoned ones of the same target, which killed runs have left and nobody
/// locks any more.
PartFile create_part_file(const std::string& target, mode_t mode);

/// The folder of a path, including the last slash; "" for the working directory.
std::string folder_of(const std::string& path);

/// Registers a part file with the signal handlers, since a signal ends the program without running destructors. While
/// the object exists, remove_unfinished() removes the file. At most 64 files can be registered at a time; others are
/// left for the next run to remove.
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

/// Removes all registered files. Async-signal-safe.
void remove_unfinished() noexcept;

/// Renames the complete files to their targets and removes the others, for each of which it calls `not_written` with
/// the target. Async-signal-safe.
void settle_unfinished(void (*not_written)(const char* target)) noexcept;

} // namespace multipath
