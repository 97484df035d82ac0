#pragma once

#include "scene/material.h"
#include "scene/text/text_lines.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace multipath {

/// What a `map_Kd` or `map_Ke` says.
struct TextureMap
{
    std::string file;     ///< as it is named, without blanks around
    std::string found;    ///< its path; empty if there is no such file
    double scale_s = 1.0; ///< `-s`, by which texture coordinates are multiplied
    double scale_t = 1.0;
    double offset_s = 0.0; ///< `-o`, added to them then
    double offset_t = 0.0;
    bool repeats = true;    ///< not `-clamp on`
    std::uint32_t line = 0; ///< 0: not given
};

/// A material as its file defines it, with what messages want to know.
struct MtlMaterial
{
    Material material;
    double opacity = 1.0;            ///< [1] `d`, or without it 1 - `Tr`; only for messages, since all is opaque here
    Rgb ambient;                     ///< `Ka`; in some files the emission of lamps
    std::uint32_t kd_line = 0;       ///< 0: not given, the material reflects nothing
    std::string flaw;                ///< "file:line: what is wrong": a reflectance above 1; empty if it is not
    std::uint32_t emission_line = 0; ///< of `Ke` or `Ka`, whichever counts; 0: not given
    TextureMap reflectance_map;      ///< `map_Kd`
    TextureMap emission_map;         ///< `map_Ke`
    bool emission_too_small = false; ///< of one colour or more, which therefore count as 0
};

/// The materials of all MTL files of a scene.
struct MaterialLibrary
{
    std::vector<MtlMaterial> materials; ///< in the order of their first definition
    std::unordered_map<std::string, std::uint32_t> number_of_name;
    std::vector<std::string> warnings;
};

/// Adds the materials of a file. Of two definitions the last counts, with a warning. Throws InputError for negative
/// reflectances, negative or infinite emission, and what else does not make sense.
void read_mtl(const std::string& path, EmissionFrom emission_from, MaterialLibrary& library);

/// What a `mtllib` statement names.
struct MtlFiles
{
    std::vector<std::string> found;   ///< paths that can be opened
    std::vector<std::string> missing; ///< names without a file
};

/// Finds the files that the argument of `mtllib` names. Names are relative to the folder of the OBJ file; they may be
/// several, in quotes, contain blanks or backslashes, or have the wrong case. Throws InputError at `place` for an
/// argument without a name.
MtlFiles find_mtl_files(std::string_view names, TextPlace place);

} // namespace multipath
