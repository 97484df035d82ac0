#pragma once

#include "geometry/surface.h"
#include "scene/rgb.h"
#include "scene/texture/texture.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// A diffuse (Lambertian) material that may emit light.
struct Material
{
    std::string name;
    /// [1] rho, 0 <= rho <= 1 in each channel; MTL `Kd`. If textured: mean over all surfaces of the material.
    Rgb reflectance;
    /// [W/m^2] E, emitted power per area (radiant exitance); MTL `Ke`, times the mean of `map_Ke`.
    Rgb emittance;
    std::string source; ///< "file:line" of the definition of the material, for messages

    static constexpr std::uint32_t no_texture = 0xffffffffu;
    std::uint32_t texture = no_texture; ///< index into SceneFile::textures, or no_texture; MTL `map_Kd`
    Rgb texture_scale = {};             ///< [1] multiplies the texture: the reflectance where the texture is white
};

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
    /// Paths of all textures that the MTL files name: where they were found, and where they are looked for first.
    std::vector<std::string> texture_files;
    std::vector<Material> materials;
    /// Names in `o` and `g` statements that apply to a face, in order of appearance; "" for faces before the first such
    /// statement. add_sky() appends "sky".
    std::vector<std::string> groups;
    /// Per group: the object that `g` divides, or the group of `g` directly before `o`; or "". Shorter for groups that
    /// no file has, and in a scene from a state.
    std::vector<std::string> other_names;

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
    bool is_flipped = false;  ///< true after flipped(); not known for a scene from a state

    /// The second name of a surface's group; "" if it has none.
    std::string other_name(std::size_t surface) const
    {
        return group[surface] < other_names.size() ? other_names[group[surface]] : "";
    }
    /// True if the surface belongs to the object or group of this name.
    bool is_named(std::size_t surface, const std::string& name) const
    {
        return groups[group[surface]] == name || (!name.empty() && other_name(surface) == name);
    }

    /// Number of surfaces without the sky.
    std::size_t own_surfaces() const { return surfaces.size() - sky_surfaces; }
    SurfaceList without_sky() const { return {surfaces.begin(), surfaces.end() - sky_surfaces}; }

    std::vector<std::string> warnings;          ///< one plain line each, beginning with "file:line:" or "file:"
    std::vector<std::string> unknown_materials; ///< names that faces use but no file defines; these materials are grey
    std::vector<std::string> unused_materials;  ///< "file:line: name" of materials that are defined but used by no face
    std::string counts;                         ///< summary: "12 materials, 1 emitter, 240 faces -> 243 surfaces"
};

/// The six walls of a room, facing inward: floor, ceiling (y is up), low x, high x, low z, high z.
inline std::array<Surface, 6> walls_of_room(Vec3 low, Vec3 size)
{
    const Vec3 x = {size.x, 0, 0};
    const Vec3 y = {0, size.y, 0};
    const Vec3 z = {0, 0, size.z};
    const Shape shape = Shape::parallelogram;
    return {{{shape, low, z, x},
             {shape, low + y, x, z},
             {shape, low, y, z},
             {shape, low + x, z, y},
             {shape, low, x, y},
             {shape, low + z, y, x}}};
}

/// The files that a scene consists of, and the names under which missing ones are looked for: none of them may become
/// an output.
std::vector<std::string> input_files(const SceneFile& file);

/// Turns one surface over: its front becomes its back. The texture stays where it is in space.
void turn_over(SceneFile& file, std::size_t surface);

/// Returns the scene with every surface turned over, for a room that was modelled to be seen from outside. To be called
/// before add_sky(), since it would turn over the sky, too.
SceneFile flipped(SceneFile file);

/// Names of the units of results: photometric if the emittances of the scene are in lm/m^2, else radiometric. The
/// numbers are computed in the same way for both.
struct LightUnits
{
    const char* power;           ///< [W] or [lm]
    const char* per_area;        ///< [W/m^2] or [lx], in ASCII
    const char* per_area_utf8;   ///< the same in UTF-8
    const char* per_area_latin1; ///< the same in ISO 8859-1
    const char* squared;         ///< square of `per_area`, the unit of mean square errors
};

inline LightUnits light_units(const SceneFile& scene)
{
    return scene.photometric ? LightUnits{"lm", "lx", "lx", "lx", "lx^2"}
                             : LightUnits{"W", "W/m^2", "W/m\u00b2", "W/m\xB2", "W^2/m^4"};
}

} // namespace multipath
