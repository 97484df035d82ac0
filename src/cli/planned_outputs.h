#pragma once

#include "cli/output_file.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

enum class OutputFormat { ppm, pfm, png, csv, svg, ply, glb, obj, html, state };

/// How a format is asked for, and what it is.
struct FormatDescription
{
    OutputFormat format;
    std::string_view extension; ///< ".ppm"
    std::string_view summary;   ///< a few words
};

/// All formats, of which each command writes some.
const std::array<FormatDescription, 10>& output_formats();

/// A file that the user asked for, already open, to be filled when the work is done.
struct PlannedOutput
{
    OutputFormat format;
    OutputFile file;
};

/// One of colours, not of numbers or meshes.
inline bool is_picture(OutputFormat format)
{
    return format == OutputFormat::ppm || format == OutputFormat::png || format == OutputFormat::pfm;
}

/// What `solve` writes.
inline const std::vector<OutputFormat> solution_formats = {OutputFormat::ppm, OutputFormat::pfm,  OutputFormat::png,
                                                           OutputFormat::csv, OutputFormat::ply,  OutputFormat::glb,
                                                           OutputFormat::obj, OutputFormat::html, OutputFormat::state};

/// The one of `formats` that a file's extension names; `-` is the first of them. Throws UsageError with the list of
/// extensions.
OutputFormat output_format(const std::string& path, const std::vector<OutputFormat>& formats = solution_formats);

/// Is one of these a picture, or, without any, will there be one?
bool wants_pictures(const std::vector<std::string>& paths);

/// Opens all outputs, so that what cannot be written is found before the work. Throws UsageError for an extension that
/// is not among the formats, a file named twice, or one that is also an input; OutputError for what cannot be written.
std::vector<PlannedOutput> open_outputs(const std::vector<std::string>& paths, const std::vector<std::string>& inputs,
                                        const std::vector<OutputFormat>& formats = solution_formats);

/// Throws UsageError for an output that is one of these files, read too, but known only since another one was read.
void require_no_input(const std::vector<PlannedOutput>& outputs, const std::vector<std::string>& inputs);

/// Puts all into place: not one before the bytes of all are on the disk. Throws OutputError.
void commit(std::vector<PlannedOutput>& outputs);

/// Do both names lead to one file? Files that do not exist yet are compared by folder and name.
bool same_file(const std::string& a, const std::string& b);

} // namespace multipath
