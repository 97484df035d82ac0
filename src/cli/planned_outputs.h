#pragma once

#include "cli/output_file.h"

#include <string>
#include <vector>

namespace multipath {

enum class OutputFormat { ppm, pfm, png, csv };

/// A file that the user asked for, already open, to be filled when the work is done.
struct PlannedOutput
{
    OutputFormat format;
    OutputFile file;
};

/// The format that a file's extension names; `-` is PPM. Throws UsageError with the list of known extensions.
OutputFormat output_format(const std::string& path);

/// Opens all outputs, so that what cannot be written is found before the work. Throws UsageError for an unknown
/// extension, a file named twice, or one that is also an input; OutputError for what cannot be written.
std::vector<PlannedOutput> open_outputs(const std::vector<std::string>& paths, const std::vector<std::string>& inputs);

} // namespace multipath
