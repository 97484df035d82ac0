#pragma once

#include "cli/files/part_file.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

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

/// A file that the user asked for, already open, to be filled when the work is done.
struct PlannedOutput
{
    std::string_view extension; ///< ".csv"; one of those that the command writes
    OutputFile file;
    std::size_t view = 0; ///< of several, which a picture shows
};

/// The one of `extensions`, string literals such as ".csv", that ends a file's name in upper or lower case; the first
/// of them for `-`. Throws UsageError with the list.
/// One that begins with "_" is the end of a name, and goes before what follows its dot.
std::string_view output_extension(const std::string& path, const std::vector<std::string_view>& extensions);

/// Opens all outputs, so that what cannot be written is found before the work. Throws UsageError for an extension that
/// is not among `extensions`, a file named twice, or one that is also an input; OutputError for what cannot be written.
std::vector<PlannedOutput> open_outputs(const std::vector<std::string>& paths, const std::vector<std::string>& inputs,
                                        const std::vector<std::string_view>& extensions);

/// Throws UsageError for an output that is one of these files, read too, but known only since another one was read.
void require_no_input(const std::vector<PlannedOutput>& outputs, const std::vector<std::string>& inputs);

/// Puts all into place: not one before the bytes of all are on the disk. Throws OutputError.
void commit(std::vector<PlannedOutput>& outputs);

/// True if both names lead to one file. Files that do not exist yet are compared by folder and name.
bool same_file(const std::string& a, const std::string& b);

} // namespace multipath
