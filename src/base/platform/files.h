#pragma once

#include <string>
#include <string_view>

// What systems do differently with files. Names are UTF-8. Files are descriptors of the C library, errors its numbers
// (errno); 0 means success. Nothing here throws.

namespace multipath {

/// Characters that end the name of a folder within a path.
extern const std::string_view folder_separators;

/// Whether names that differ only in upper and lower case are names of one file.
extern const bool names_ignore_case;

/// Creates an empty file, open for writing. `is_private`: only the user may read it. -1: see errno; EEXIST if the name
/// is taken.
int create_file(const std::string& path, bool is_private);

/// Opens a device or a pipe for writing; -1: see errno.
int open_device(const std::string& path);

/// A new descriptor of standard output; -1: see errno.
int copy_standard_output();

/// Writes all bytes. EPIPE: the reader has closed the pipe.
int write_all(int descriptor, std::string_view bytes);

/// Waits until all bytes are on the disk, where the file system can tell.
int flush(int descriptor);

int close_file(int descriptor);

/// Whether an existing file may be written.
int check_writable(const std::string& path);

/// Renames a file, and replaces the one that has the name, in one step. Async-signal-safe.
int rename_over(const char* from, const char* to) noexcept;

/// Errors are ignored. Async-signal-safe.
void remove_file(const char* path) noexcept;

} // namespace multipath
