#pragma once

#include "geometry/bounds.h"
#include "scene/material.h"
#include "scene/scene_file.h"
#include "scene/tessellation.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace multipath {

class Intersector;

/// A patch: the surface that it is part of, and its shape.
struct Patch
{
    std::uint32_t surface = 0;
    Surface shape; ///< the patch as a small surface; the front of a back patch is the back of the surface
};

/// A scene ready for solving: surfaces for intersection, patches for radiosity. Immutable.
/// Patches are numbered surface by surface; in a two-sided scene all front patches come before all back patches.
class Scene
{
public:
    static constexpr std::uint32_t no_patch = 0xffffffffu;

    /// Divides every surface, except those of the sky, into patches with edges of at most patch_size [scene units].
    /// Throws InputError for a scene without surfaces or light, SettingsError if there would be 2^31 patches or more.
    Scene(SceneFile file, double patch_size, bool two_sided = false, int threads = 1);
    Scene(std::shared_ptr<const SceneFile> file, double patch_size, bool two_sided, int threads);

    /// The same scene with its cells subdivided by quadtrees. `levels` holds the level of each leaf, surface after
    /// surface (see CellTrees). Throws std::invalid_argument if the levels do not form complete trees, SettingsError
    /// for 2^31 patches or more.
    Scene refined(const std::vector<std::uint8_t>& levels, int threads = 1) const;
    /// The levels of all leaves, as refined() takes them; empty if no cell is subdivided.
    std::vector<std::uint8_t> levels() const;

    const std::string& path() const { return file_->path; }
    const std::vector<Material>& materials() const { return file_->materials; }
    const SurfaceList& surfaces() const { return file_->surfaces; }
    const SceneFile& file() const { return *file_; }
    std::shared_ptr<const SceneFile> shared_file() const { return file_; } ///< for owners that outlive the scene
    const Intersector& intersector() const { return *intersector_; }
    const Bounds& bounds() const { return bounds_; }
    bool two_sided() const { return two_sided_; }
    double patch_size() const { return patch_size_; } ///< [scene units]
    std::uint64_t hash() const { return hash_; }      ///< see scene_hash()

    std::uint32_t patch_count() const { return patch_count_; }
    std::uint32_t surface_of(std::uint32_t patch) const { return surface_of_[cell_of(patch)]; }
    bool is_front(std::uint32_t patch) const { return patch < cell_count_; }
    /// The corners of a patch on the grid of its surface; those of a back patch are in the order of its front patch.
    CellCorners corners(std::uint32_t patch) const
    {
        const std::uint32_t surface = surface_of(patch);
        return tessellations_[surface].corners(cell_of(patch) - first_cell_[surface]);
    }
    const Material& surface_material(std::uint32_t surface) const { return file_->materials[file_->material[surface]]; }
    const Material& material_of(std::uint32_t patch) const { return surface_material(surface_of(patch)); }
    Patch patch(std::uint32_t patch) const;
    double area(std::uint32_t patch) const; ///< [m^2]
    std::vector<double> areas() const;      ///< [m^2] of all patches
    /// [m^2] Weights of the patches in means over the scene: their areas, but 0 for the sky.
    std::vector<double> weights() const;
    Rgb reflectance(std::uint32_t patch) const ///< [1]; if textured, the mean over the patch
    {
        return reflectance_.empty() ? material_of(patch).reflectance : reflectance_[cell_of(patch)];
    }
    /// [1] Reflectance at a point of a surface, with its texture.
    Rgb reflectance_at(std::uint32_t surface, double u, double v) const;
    /// True if the surface is textured and has texture coordinates; otherwise it has one colour.
    bool shows_texture(std::uint32_t surface) const
    {
        return is_textured(surface) && file().texture_frames[surface].known;
    }
    bool is_textured(std::uint32_t surface) const { return surface_material(surface).texture != Material::no_texture; }
    /// [W/m^2]; only front patches emit.
    Rgb emittance(std::uint32_t patch) const { return is_front(patch) ? material_of(patch).emittance : Rgb{}; }

    /// [W/m^2] Irradiance from the sun, with shadows, averaged over the patch.
    Rgb sunlight(std::uint32_t patch) const
    {
        return sun_shares_.empty() ? Rgb{} : sun_shares_[patch] * file_->sun->irradiance;
    }
    /// [W/m^2] Radiosity before any light is exchanged between patches: emitted light and reflected sunlight.
    Rgb first_light(std::uint32_t patch) const { return emittance(patch) + reflectance(patch) * sunlight(patch); }
    /// [W/m^2] Irradiance from the sun at a point of a surface (or Intersector::no_surface), on the side with this
    /// normal.
    Rgb sunlight(std::uint32_t surface, Vec3 point, Vec3 normal) const;

    /// Number of surfaces without those of the sky, which come last.
    std::uint32_t own_surfaces() const { return static_cast<std::uint32_t>(file_->own_surfaces()); }
    bool is_sky(std::uint32_t surface) const { return surface >= own_surfaces(); }
    Bounds own_bounds() const; ///< without the sky

    /// The patch at (u, v) on one side of a surface, or no_patch for the back of a one-sided surface.
    std::uint32_t patch_at(std::uint32_t surface, double u, double v, bool front) const;
    /// The patches at (u, v) on both sides of a surface; `none` for the back of a one-sided surface.
    struct Sides
    {
        std::uint32_t front;
        std::uint32_t back;
    };
    Sides patches_at(std::uint32_t surface, double u, double v, std::uint32_t none) const;
    const Tessellation& tessellation(std::uint32_t surface) const { return tessellations_[surface]; }
    /// The first patch on a side of a surface, which must exist; the others follow.
    std::uint32_t first_patch(std::uint32_t surface, bool front = true) const
    {
        return first_cell_[surface] + (front ? 0 : cell_count_);
    }

    double own_area() const { return own_area_; }                 ///< [m^2] of all existing sides, without the sky
    double total_area() const { return total_area_; }             ///< [m^2] A_T, of all existing sides, with the sky
    Rgb lamp_power() const { return lamp_power_; }                ///< [W] emitted by surfaces
    Rgb source_power() const { return lamp_power_ + sun_power_; } ///< [W] Phi_T, emitted power and sunlight
    /// [1] R_ave, area-weighted mean over all sides; sources are included, as in the paper.
    Rgb average_reflectance() const { return average_reflectance_; }

private:
    std::uint32_t cell_of(std::uint32_t patch) const { return patch < cell_count_ ? patch : patch - cell_count_; }
    void number_cells();
    void compute_sunlight(int threads);
    void compute_textured_reflectances(int threads);

    std::shared_ptr<const SceneFile> file_;
    bool two_sided_ = false;
    double patch_size_ = 0.0;
    std::shared_ptr<const Intersector> intersector_; ///< shared by copies of the scene
    Bounds bounds_;
    LargeVector<Tessellation> tessellations_; ///< per surface
    LargeVector<std::uint32_t> first_cell_;   ///< per surface
    LargeVector<double> cell_area_;           ///< per surface [m^2], of cells that are not subdivided
    LargeVector<std::uint32_t> surface_of_;   ///< per cell
    std::uint32_t cell_count_ = 0;
    std::uint32_t patch_count_ = 0;
    std::uint64_t hash_ = 0;
    double own_area_ = 0.0;
    double total_area_ = 0.0;
    std::vector<Rgb> reflectance_;   ///< [1] per cell; empty if no material is textured
    std::vector<double> sun_shares_; ///< [1] per patch: sunlight() / sun->irradiance; empty without a sun
    Rgb lamp_power_;
    Rgb sun_power_;
    Rgb average_reflectance_;
};

inline double Scene::area(std::uint32_t patch) const
{
    const std::uint32_t surface = surface_of(patch);
    const Tessellation& tessellation = tessellations_[surface];
    if (!tessellation.trees)
        return cell_area_[surface];
    const std::uint8_t level = tessellation.level(cell_of(patch) - first_cell_[surface]);
    return cell_area_[surface] / static_cast<double>(std::uint64_t{1} << 2 * level);
}

// Inline: called for every intersection of a line.
inline std::uint32_t Scene::patch_at(std::uint32_t surface, double u, double v, bool front) const
{
    const Sides sides = patches_at(surface, u, v, no_patch);
    return front ? sides.front : sides.back;
}

inline Scene::Sides Scene::patches_at(std::uint32_t surface, double u, double v, std::uint32_t none) const
{
    const std::uint32_t cell = first_cell_[surface] + tessellations_[surface].cell_at(u, v);
    return {cell, two_sided_ ? cell_count_ + cell : none};
}

/// The number of cells at this patch size; a real number, like that of tessellation.h. Each sky surface is one cell.
double cell_count(const SceneFile& file, double patch_size);

/// Identifies what a result was computed from: geometry, reflectances, emittances, textures, the sun, subdivision and
/// sides, but not names, comments or the spelling of numbers. A chain of mix_bits() over 64-bit values, the same on
/// every machine.
std::uint64_t scene_hash(const SceneFile& file, const LargeVector<Tessellation>& tessellations, bool two_sided);

} // namespace multipath
