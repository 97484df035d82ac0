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

/// A part file that must not outlive a program which a signal ends: its destructors do not run then. As long as one
/// lives, remove_unfinished() removes the file. Of more than 64 at a time the others stay, for the next run to remove.
class Unfinished
{
public:
    Unfinished() = default; ///< of nothing
    /// `target`: the file that it will become.
    Unfinished(const std::string& path, const std::string& target);
    ~Unfinished() { forget(); }
    Unfinished(Unfinished&& other) noexcept;
    Unfinished& operator=(Unfinished&& other) noexcept;

    /// Nothing is missing but the target's name.
    void complete() noexcept;

private:
    void forget() noexcept;

    static constexpr int none = -1;

    int slot_ = none;
};

/// Removes all of them. A handler of signals may call it.
void remove_unfinished() noexcept;

/// The same, but what is complete gets the name of its target. `not_written` is called with the target of each of the
/// others.
void settle_unfinished(void (*not_written)(const char* target)) noexcept;

} // namespace multipath
