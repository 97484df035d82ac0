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
    Rgb irradiance; ///< [W/m^2] on a plane that faces the sun, without shadows
};

/// The contents of an OBJ file and its materials, before its surfaces are subdivided into patches: the output of the
/// reader and the input of a Scene. Coordinates are in scene units; one unit counts as 1 m.
struct SceneFile
{
    std::string path;
    std::vector<std::string> material_files; ///< paths of all MTL files that were read, even if no face uses them
    std::vector<Material> materials;
    /// Names in `o` and `g` statements that apply to a face, in order of appearance; "" for faces before the first such
    /// statement. add_sky() appends "sky".
    std::vector<std::string> groups;

    /// `surfaces`, `material`, `group` and `line` have one entry per surface. The surfaces are in the order of their
    /// faces in the file; those of the sky come last.
    SurfaceList surfaces;
    std::vector<std::uint32_t> material; ///< index into materials
    std::vector<std::uint32_t> group;    ///< index into groups
    /// Line of the face in the file; that of the first face if several were joined into one surface; 0 for the sky.
    std::vector<std::uint32_t> line;

    std::vector<std::shared_ptr<const Texture>> textures;
    std::vector<TextureFrame> texture_frames; ///< one per surface except the sky; empty if there are no textures

    std::uint32_t sky_surfaces = 0; ///< number of surfaces of the sky, which encloses the scene
    std::optional<Sun> sun;
    bool photometric = false; ///< true if emittances are in lm/m^2; then W stands for lm everywhere

    /// Number of surfaces without the sky.
    std::size_t own_surfaces() const { return surfaces.size() - sky_surfaces; }

    std::vector<std::string> warnings;          ///< one plain line each, beginning with "file:line:" or "file:"
    std::vector<std::string> unknown_materials; ///< names that faces use but no file defines; these materials are grey
    std::vector<std::string> unused_materials;  ///< "file:line: name" of materials that are defined but used by no face
    std::size_t dropped_faces = 0; ///< faces that were dropped: without area, or with fewer than three vertices
    std::string counts; ///< summary: "12 materials, 1 emitter, 240 faces -> 243 surfaces; 3 zero-area faces dropped"
};

/// Turns one surface over: its front becomes its back. The texture stays where it is in space.
void turn_over(SceneFile& file, std::size_t surface);

/// Returns the scene with every surface turned over, for a room that was modelled to be seen from outside. To be called
/// before add_sky(), since it would turn over the sky, too.
SceneFile flipped(SceneFile file);

} // namespace multipath
