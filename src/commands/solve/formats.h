#pragma once

#include "cli/files/planned_outputs.h"
#include "cli/options/option_table.h"
#include "commands/options/picture_options.h"
#include "radiosity/solve.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

// The formats in which `solve` and the commands like it write a solution.

namespace multipath {

enum class OutputFormat { ppm, pfm, png, csv, ply, glb, obj, html, state };

/// In the order in which files are made: numbers first, so that what a signal costs can be made again from the rest.
enum class FormatKind { numbers, mesh, picture, page };

/// How a format is asked for, and what it is.
struct FormatDescription
{
    OutputFormat format;
    FormatKind kind;
    std::string_view extension; ///< ".ppm"
    std::string_view summary;   ///< a few words
};

/// All formats; the first one is that of standard output.
const std::array<FormatDescription, 9>& output_formats();

/// The format that a file's extension names. Throws UsageError with the list of extensions.
OutputFormat output_format(const std::string& path);
OutputFormat format_of(const PlannedOutput& output);

/// --output, --quiet and the like, of every command that writes solutions.
OptionGroup solution_output_group();

/// NAME.ppm and NAME.png in the working directory, for a file NAME.*.
std::vector<std::string> default_outputs(const std::string& path);

/// True if one of these is a picture, or if there are none, since pictures are the default.
bool wants_pictures(const std::vector<std::string>& paths);

/// open_outputs() with these formats.
std::vector<PlannedOutput> open_solution_outputs(const std::vector<std::string>& paths,
                                                 const std::vector<std::string>& inputs);

bool has_format(const std::vector<PlannedOutput>& outputs, OutputFormat format);

/// True if one of them shows the scene from a camera, or with the exposure of such a picture.
bool has_view(const std::vector<PlannedOutput>& outputs);

/// The bytes of the formats that are made elsewhere, pages and states.
using FormatMakers = std::map<OutputFormat, std::function<std::string()>>;

/// Fills every output in its format and puts all into place. The comments go into the formats that have a place for
/// them. Throws OutputError.
void write_outputs(std::vector<PlannedOutput>& outputs, const Scene& scene, const Solution& solution,
                   const PictureOptions& picture_options, const std::vector<std::string>& comments,
                   const FormatMakers& makers);

} // namespace multipath
