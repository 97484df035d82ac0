#pragma once

#include "geometry/surface.h"
#include "scene/material.h"
#include "scene/texture/texture.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// A directional light source.
struct Sun
{
    Vec3 direction; ///< unit vector towards the sun
    Rgb irradiance; ///< [W/m^2] of a plane that faces the sun
};

/// The contents of an OBJ file and its materials, before subdivision: the output of the reader, the input of a Scene.
struct SceneFile
{
    std::string path;
    std::vector<std::string> material_files; ///< paths of all MTL files read, used by a face or not
    std::vector<Material> materials;
    std::vector<std::string> groups; ///< names of `o` and `g` statements, in order of appearance; at least one ("")

    /// These four have one entry per surface.
    SurfaceList surfaces;
    std::vector<std::uint32_t> material; ///< index into materials
    std::vector<std::uint32_t> group;    ///< index into groups
    std::vector<std::uint32_t> line; ///< line of its face in the file, also of each part of a cut face; 0 for the sky

    std::vector<std::shared_ptr<const Texture>> textures;
    std::vector<TextureFrame> texture_frames; ///< one per surface except the sky; empty without textures

    std::uint32_t sky_surfaces = 0; ///< number of the last surfaces, which enclose the scene
    std::optional<Sun> sun;
    bool photometric = false; ///< emittances are in lm/m^2, so results are in lm and lx

    std::size_t own_surfaces() const { return surfaces.size() - sky_surfaces; }

    std::vector<std::string> warnings;          ///< one plain line each, with file:line
    std::vector<std::string> unknown_materials; ///< names that faces use but no file defines; they are grey
    std::vector<std::string> unused_materials;  ///< "file:line: name", defined but used by no face
    std::size_t dropped_faces = 0;              ///< faces without area, which were dropped
    std::string counts; ///< summary: "12 materials, 1 emitter, 240 faces -> 243 surfaces; 3 zero-area faces dropped"
};

/// Turns one surface over; its texture stays in place.
void turn_over(SceneFile& file, std::size_t surface);

/// The scene with every surface turned over, for a room that was modelled to be seen from outside.
SceneFile flipped(SceneFile file);

} // namespace multipath
