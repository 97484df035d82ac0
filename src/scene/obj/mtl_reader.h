#pragma once

#include "scene/material.h"
#include "scene/text/text_lines.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace multipath {

/// A `map_Kd` or `map_Ke` statement.
struct TextureMap
{
    std::string file;     ///< name in the statement, without blanks around it
    std::string found;    ///< path of the file; empty if there is none
    double scale_s = 1.0; ///< `-s`, factor of texture coordinates
    double scale_t = 1.0;
    double offset_s = 0.0; ///< `-o`, added to the scaled coordinates
    double offset_t = 0.0;
    bool repeats = true;    ///< false after `-clamp on`
    std::uint32_t line = 0; ///< 0 if the statement is missing
};

/// A material as its file defines it, with details for messages.
struct MtlMaterial
{
    Material material;
    double opacity = 1.0;      ///< [1] `d`, or 1 - `Tr` if there is no `d`; only for messages: all surfaces are opaque
    Rgb ambient;               ///< `Ka`; some files describe lamps by it
    std::uint32_t kd_line = 0; ///< 0 if missing: the material reflects nothing
    std::string flaw;          ///< "file:line: what is wrong" for a reflectance above 1; otherwise empty
    std::uint32_t emission_line = 0; ///< of the `Ke` or `Ka` used as emittance; 0 if missing
    TextureMap reflectance_map;      ///< `map_Kd`
    TextureMap emission_map;         ///< `map_Ke`
    bool emission_too_small = false; ///< a channel is positive but too small, and counts as 0
};

/// The materials of all MTL files of a scene.
struct MaterialLibrary
{
    std::vector<MtlMaterial> materials; ///< in the order of their first definition
    std::unordered_map<std::string, std::uint32_t> number_of_name;
    std::vector<std::string> warnings;
};

/// Adds the materials of an MTL file to a library. A later definition of a name replaces an earlier one, with a
/// warning. Throws InputError for a negative reflectance, an emission that is negative or above 1e30, and malformed
/// statements.
void read_mtl(const std::string& path, EmissionFrom emission_from, MaterialLibrary& library);

/// The files named by a `mtllib` statement.
struct MtlFiles
{
    std::vector<std::string> found;   ///< paths that can be opened
    std::vector<std::string> missing; ///< names without a file
};

/// Finds the files named by the argument of `mtllib`, relative to the folder of the OBJ file. There may be several
/// names; they may be quoted, contain blanks or backslashes, or be in the wrong case. Throws InputError, with the line
/// `place`, for no name or more than 32 words.
MtlFiles find_mtl_files(std::string_view names, TextLocation place);

} // namespace multipath
