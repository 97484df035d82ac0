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

/// Parallel light from far away.
struct Sun
{
    Vec3 direction; ///< unit vector toward it
    Rgb irradiance; ///< [W/m^2] of a plane that faces it
};

/// What an OBJ file and its materials say, before subdivision: the output of the reader, the input of a Scene.
struct SceneFile
{
    std::string path;
    std::vector<std::string> material_files; ///< paths of all that were read, whether or not a face uses them
    std::vector<Material> materials;
    std::vector<std::string> groups; ///< names of `o` and `g` statements, in order of appearance; at least one ("")

    /// One entry per surface in all of these.
    SurfaceList surfaces;
    std::vector<std::uint32_t> material; ///< index into materials
    std::vector<std::uint32_t> group;    ///< index into groups
    std::vector<std::uint32_t> line;     ///< line of the face in the file; two surfaces of one polygon share it

    std::vector<std::shared_ptr<const Texture>> textures;
    std::vector<TextureFrame> texture_frames; ///< one per surface but for the sky; empty if there are no textures

    std::uint32_t sky_surfaces = 0; ///< the last ones: they lie around the scene and are no part of it
    std::optional<Sun> sun;
    bool photometric = false; ///< emittances are in lm/m^2, and all results in lm and lx

    std::size_t own_surfaces() const { return surfaces.size() - sky_surfaces; }

    std::vector<std::string> warnings;          ///< one plain line each, with file:line
    std::vector<std::string> unknown_materials; ///< names that faces use and no file defines; grey stands in
    std::vector<std::string> unused_materials;  ///< "file:line: name", defined and used by no face
    std::size_t dropped_faces = 0;              ///< without an area
    std::string counts; ///< "12 materials, 1 emitter, 240 faces -> 243 surfaces; 3 zero-area faces dropped"
};

/// Turns one face over; its texture stays where it is.
void turn_over(SceneFile& file, std::size_t surface);

/// The same with every face turned over: a room that was modelled to be seen from outside.
SceneFile flipped(SceneFile file);

} // namespace multipath
