#pragma once

#include "scene/scene_file.h"
#include "scene/text/text_lines.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace multipath {

/// A `map_Kd`, `map_Ke` or `map_d` statement. The texture is read at scale * (s, t) + offset.
struct TextureMap
{
    std::string file;                ///< name in the statement, without blanks or quotes around it
    std::string found;               ///< path of the file; empty if it was not found
    TexturePoint scale = {1.0, 1.0}; ///< `-s`
    TexturePoint offset;             ///< `-o`
    bool repeats = true;             ///< false after `-clamp on`
    std::uint32_t line = 0;          ///< line of the statement; 0 if the material has none

    TexturePoint at(TexturePoint p) const { return {scale.s * p.s + offset.s, scale.t * p.t + offset.t}; }
};

/// A material as its file defines it, with details for messages. read_mtl() gives it the whole argument of `newmtl` as
/// its name.
struct MtlMaterial
{
    Material material;
    double opacity = 1.0;            ///< [1] `d`, for messages only, since all surfaces are opaque
    std::uint32_t kd_line = 0;       ///< line of `Kd`; 0 if missing: the material is black unless it has a `map_Kd`
    std::string flaw;                ///< "file:line: what is wrong" if the reflectance is above 1; otherwise empty
    std::uint32_t emission_line = 0; ///< line of the `Ke`; 0 if missing
    TextureMap reflectance_map;      ///< `map_Kd`
    TextureMap emission_map;         ///< `map_Ke`
    TextureMap opacity_map;          ///< `map_d`
    bool is_unknown = false;         ///< stands in for a material that no file defines
};

/// The materials of all MTL files of a scene.
struct MaterialLibrary
{
    std::vector<MtlMaterial> materials;                            ///< in the order of their first definition
    std::unordered_map<std::string, std::uint32_t> number_of_name; ///< index into `materials`
    /// Paths of all textures that the files name: where they were found, and where they are looked for first.
    std::vector<std::string> texture_files;
    std::vector<std::string> warnings;
};

/// Adds the materials of an MTL file to a library. A later definition of a name replaces an earlier one, with a
/// warning. Emission below 1e-30 counts as 0. Other statements than Kd, the emission and their textures are ignored,
/// with a warning. Throws InputError for a file that cannot be read; for a reflectance or an emission that is
/// malformed, negative or before the first `newmtl`; for an emission above 1e30; and for a texture before the first
/// `newmtl`.
void read_mtl(const std::string& path, MaterialLibrary& library);

/// The files that a `mtllib` statement names.
struct MtlFiles
{
    std::vector<std::string> found;   ///< paths of existing regular files
    std::vector<std::string> missing; ///< names for which there is no file
};

/// Finds the MTL files listed in `names`, the argument of a `mtllib` statement, relative to the folder of the OBJ file.
/// Several names may be given: each is in quotes, or ends at a word with the ending ".mtl". A name may contain blanks
/// or backslashes, or be in the wrong case. Throws InputError for no name or more than 32. `place` is the location of
/// the statement in the OBJ file.
MtlFiles find_mtl_files(std::string_view names, TextLocation place);

} // namespace multipath
