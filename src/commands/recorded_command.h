#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// What a file is that provenance() can be read from.
enum class RecordedFile { table, ppm, png, drawing, report, page, ply, glb, obj };

/// What a file says of where it comes from: the inverse of provenance().
struct RecordedCommand
{
    RecordedFile kind;
    std::string version;            ///< "multipath 0.1.0"; empty where the file does not tell
    std::vector<std::string> words; ///< behind `multipath`, at least one: the command's name
    std::optional<std::string> seed;
    std::optional<std::string> scene; ///< hash
};

/// Reads it from the bytes of a CSV, PPM, PNG, SVG, HTML, PLY, GLB or OBJ; `path` is for messages. Throws
/// InputError for any other file, for one without a command, and for a command that is not one of `multipath`, or does
/// not fit a shell's grammar of plain and quoted words. Whether there is such a command, and such options, is not
/// looked at.
RecordedCommand read_recorded_command(const std::string& bytes, const std::string& path);

/// The range of a drawing's bytes that holds its record, the inside of its <desc>; empty where there is none.
std::string_view drawing_record(std::string_view bytes);

/// The range of a GLB's bytes that holds its record, a list of texts in JSON without the brackets; empty where there is
/// none.
std::string_view glb_record(std::string_view bytes);

} // namespace multipath
