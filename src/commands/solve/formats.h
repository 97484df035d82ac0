#pragma once

#include "cli/files/output_file.h"
#include "cli/options/command_line.h"
#include "commands/options/picture_options.h"
#include "radiosity/run/solution.h"
#include "scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

// The formats in which `solve` and the commands like it write a solution.

namespace multipath {

class SolvedScene; // formats.cpp
struct SolveJob;

/// Kinds of formats in the order in which files are made: the quickest first. If a signal ends the program, the
/// remaining files can be made from the state.
enum class FormatKind { state, table, mesh, picture, page };

/// A format: one row of the table in formats.cpp. A new format is a function in `image` or `export` and a row.
struct OutputFormat
{
    std::string_view name; ///< extension, ".ppm" or "_lightmap.glb", see output_extension()
    FormatKind kind;
    std::string_view summary;           ///< a few words
    std::string (*bytes)(SolvedScene&); ///< makes the content of a file
};

/// All formats. The first one is used for standard output.
std::vector<OutputFormat> output_formats();

/// The kind of the format that the ending of a file name selects. Throws UsageError with the list of extensions if
/// there is none.
FormatKind kind_of(const std::string& path);

/// True if one of the outputs is of this kind.
bool has_kind(const std::vector<PlannedOutput>& outputs, FormatKind kind);

/// The options --output, --quiet, ... of every command that writes solutions.
OptionGroup solution_output_group();

/// The default outputs for an input NAME.*: NAME.ppm and NAME.png in the working directory.
std::vector<std::string> default_outputs(const std::string& path);

/// Calls open_outputs() with these formats and throws the same errors. If there are several views, every picture
/// becomes one file for each view: "room.png" becomes "room-door.png" for the view `door`; a picture on standard output
/// is a UsageError in this case. Throws InputError if the memory that `line` allows cannot hold a picture.
std::vector<PlannedOutput> open_solution_outputs(const CommandLine& line, const std::vector<std::string>& paths,
                                                 const std::vector<std::string>& inputs,
                                                 const PictureOptions& pictures);

/// Writes the solution into every output in its format and commits all. Prints, unless the job is quiet, the statistics
/// of a grid that was written, and warnings, and returns a line "wrote FILE" for each file, which the caller prints
/// last. `state`: the bytes of a state; may be empty if there is none among the outputs. Throws OutputError. Throws
/// InputError if a format cannot hold the result, and SettingsError for a grid that has no points or more than a
/// million.
std::string write_outputs(std::vector<PlannedOutput>& outputs, const SolveJob& job, const Scene& scene,
                          const Solution& solution, const std::string& state);

} // namespace multipath
