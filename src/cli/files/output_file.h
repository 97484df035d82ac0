#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The folder of a path, including the last slash; "" for the working directory.
std::string folder_of(const std::string& path);

/// The registration of a part file with the signal handlers, since a signal ends the program without running
/// destructors.
struct UnfinishedSlot;
struct ForgetUnfinished
{
    void operator()(UnfinishedSlot* slot) const noexcept;
};
using Unfinished = std::unique_ptr<UnfinishedSlot, ForgetUnfinished>;

/// Registers a part file that will be renamed to `target`. At most 64 files with paths below 4096 bytes can be
/// registered at a time; others get null, and a signal leaves them for the next run to remove.
Unfinished unfinished(const std::string& path, const std::string& target);

/// Marks the file as complete: only the rename is left. No effect on null.
void complete(const Unfinished& file) noexcept;

/// Renames the complete files to their targets and removes the others. Calls `not_written` with the target of each file
/// that was not renamed. Async-signal-safe.
void settle_unfinished(void (*not_written)(const char* target)) noexcept;

/// Makes the folder if it does not exist. Throws OutputError if that fails, or if the path is something else than a
/// folder.
void make_folder(const std::string& path);

/// An output that appears under its name only when it is complete. The constructor checks that the target can be
/// written; call it before the work. The bytes go to a temporary file in the folder of the target. commit() renames the
/// temporary file; without commit() the destructor removes it. The path `-` is standard output. Devices and pipes are
/// written directly. A symbolic link is followed, not replaced.
class OutputFile
{
public:
    /// Throws OutputError, as write(), complete() and commit() do. After an error an existing target file is unchanged.
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(OutputFile&& other) noexcept;

    /// Appends the bytes.
    void write(std::string_view bytes);

    /// Flushes all bytes to the disk (fsync). After that only the rename is left, for commit() or for the signal
    /// handler of end_at_interrupts().
    void complete();

    /// Completes the file and renames it to the target. Nothing may be written afterwards.
    void commit();

    /// The name as the user gave it; "standard output" for `-`.
    const std::string& name() const { return name_; }

private:
    void open(int descriptor);
    void discard() noexcept;
    void discard_at(int error);

    std::string name_;
    std::string target_;    ///< path without symbolic links at its end
    std::string temporary_; ///< empty: target written directly, or file committed, discarded or moved from
    Unfinished unfinished_; ///< registers the temporary file with the signal handlers
    int descriptor_ = -1;   ///< -1: committed, discarded or moved from
};

/// An output that the user asked for. It is opened before the work and written after it.
struct PlannedOutput
{
    std::string_view extension; ///< ".csv"; one of the extensions that the command writes
    OutputFile file;
    std::size_t view = 0; ///< index of the view that a picture shows
};

/// The entry of `extensions` (string literals such as ".csv") with which the name of a file ends; the first entry for
/// `-`. The name may be in upper or lower case. Longer entries, such as "_lightmap.glb", take precedence over plain
/// extensions. Throws UsageError with the list of entries if none fits.
std::string_view output_extension(const std::string& path, const std::vector<std::string_view>& extensions);

/// Opens all outputs, so that an unwritable one is reported before the work. Throws UsageError for an extension that is
/// not among `extensions`, for a file named twice, and for a file that is also among the `inputs`. Throws OutputError
/// for an unwritable file.
std::vector<PlannedOutput> open_outputs(const std::vector<std::string>& paths, const std::vector<std::string>& inputs,
                                        const std::vector<std::string_view>& extensions);

/// Throws UsageError if an output is also one of these inputs. For inputs that are known late, such as the material
/// files that a scene names.
void require_no_input(const std::vector<PlannedOutput>& outputs, const std::vector<std::string>& inputs);

/// Commits all outputs. Flushes the bytes of every output to the disk before the first one is renamed to its target.
/// Throws OutputError.
void commit(std::vector<PlannedOutput>& outputs);

/// True if both names refer to the same file. If one of the files does not exist yet, folders and names are compared.
/// Throws OutputError for circular links.
bool same_file(const std::string& a, const std::string& b);

} // namespace multipath
