#pragma once

#include "cli/files/output_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// A file that the user asked for, already open, to be filled when the work is done.
struct PlannedOutput
{
    std::string_view extension; ///< ".csv"; one of those that the command writes
    OutputFile file;
};

/// The one of `extensions`, string literals such as ".csv", that ends a file's name in upper or lower case; the first
/// of them for `-`. Throws UsageError with the list.
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
