#pragma once

#include "cli/files/unfinished.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace multipath {

/// A result could not be written: exit code 1. One plain line, "cannot write out/room.png: No space left on device".
class OutputError : public std::runtime_error
{
public:
    explicit OutputError(const std::string& message) : std::runtime_error(message) {}
};

/// Whoever read standard output has left, as `head` does: exit code 1 as well, but nothing to tell anybody.
class ReaderGone : public OutputError
{
public:
    using OutputError::OutputError;
};

/// Where the symbolic links at the end of a path lead, also when the last one leads to a file that does not exist yet.
/// Throws OutputError for links in a circle.
std::string follow_links(const std::string& path);

/// Makes the folder if there is none. Throws OutputError.
void make_folder(const std::string& path);

/// A file that appears under its name only when it is complete. The constructor finds out whether the target can be
/// written (do this before the work); the bytes go to a temporary beside it, which commit() renames and the destructor
/// removes.
/// `-` is standard output. Devices and pipes are written directly; a symbolic link is followed, not replaced.
class OutputFile
{
public:
    /// Throws OutputError, as do write(), complete() and commit(). After any of them an existing target is as it was.
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(OutputFile&& other) noexcept;

    /// Appends.
    void write(std::string_view bytes);

    /// Brings all bytes to the disk, so that a commit, or watch_interrupts() at a signal, only has a name to change.
    void complete();

    /// Puts the file in place, on the disk; nothing may be written afterwards.
    void commit();

    /// The name as the user gave it; "standard output" for `-`.
    const std::string& name() const { return name_; }

private:
    void discard() noexcept;

    std::string name_;
    std::string target_;    ///< where the symbolic links lead
    std::string temporary_; ///< empty: written directly, or done
    Unfinished unfinished_; ///< the temporary, for signals
    int descriptor_ = -1;   ///< -1: done or moved from
};

} // namespace multipath
