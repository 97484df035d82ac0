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

/// Where a patch lies.
struct Patch
{
    std::uint32_t surface = 0;
    Surface shape; ///< the patch itself, as a small surface; for a back side its front is the back of the surface
};

/// A scene ready for solving: surfaces for intersection, patches for radiosity. Immutable.
/// Patches are numbered surface by surface; with two sides, all fronts come before all backs.
class Scene
{
public:
    static constexpr std::uint32_t no_patch = 0xffffffffu;

    /// Cuts every surface into patches no longer than patch_size [scene units].
    /// Throws InputError for a scene without surfaces or light, SettingsError for more patches than fit (2^31).
    Scene(SceneFile file, double patch_size, bool two_sided = false, int threads = 1);
    Scene(std::shared_ptr<const SceneFile> file, double patch_size, bool two_sided, int threads);

    /// The same scene with cells cut further: `levels` of the leaves of all surfaces, one after the other (CellTrees).
    /// Throws std::invalid_argument if they do not form whole trees.
    Scene refined(const std::vector<std::uint8_t>& levels, int threads = 1) const;
    /// As refined() takes them; empty if all cells are whole.
    std::vector<std::uint8_t> levels() const;

    const std::string& path() const { return file_->path; }
    const std::vector<Material>& materials() const { return file_->materials; }
    const SurfaceList& surfaces() const { return file_->surfaces; }
    const SceneFile& file() const { return *file_; }
    std::shared_ptr<const SceneFile> shared_file() const { return file_; } ///< for who keeps it without the scene
    const Intersector& intersector() const { return *intersector_; }
    const Bounds& bounds() const { return bounds_; }
    bool two_sided() const { return two_sided_; }
    double patch_size() const { return patch_size_; } ///< [scene units]
    std::uint64_t hash() const { return hash_; } ///< of geometry, materials and subdivision; stable across machines

    std::uint32_t patch_count() const { return patch_count_; }
    std::uint32_t surface_of(std::uint32_t patch) const { return surface_of_[cell_of(patch)]; }
    bool is_front(std::uint32_t patch) const { return patch < cell_count_; }
    /// Between which points of its surface's grid a patch lies; a back in the order of the front on its other side.
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
    /// [m^2] By which patches count in means over the scene: their areas, 0 for those of the sky.
    std::vector<double> weights() const;
    Rgb reflectance(std::uint32_t patch) const ///< [1] of a textured patch the mean
    {
        return reflectance_.empty() ? material_of(patch).reflectance : reflectance_[cell_of(patch)];
    }
    /// [1] At a point of a surface, as its texture shows it.
    Rgb reflectance_at(std::uint32_t surface, double u, double v) const;
    /// It is textured and lies on its texture; else it has the colour of its material.
    bool shows_texture(std::uint32_t surface) const
    {
        return is_textured(surface) && file().texture_frames[surface].known;
    }
    bool is_textured(std::uint32_t surface) const { return surface_material(surface).texture != Material::no_texture; }
    /// [W/m^2]; only fronts emit
    Rgb emittance(std::uint32_t patch) const { return is_front(patch) ? material_of(patch).emittance : Rgb{}; }

    /// [W/m^2] Irradiance by the sun, mean over the patch.
    Rgb sunlight(std::uint32_t patch) const
    {
        return sun_shares_.empty() ? Rgb{} : sun_shares_[patch] * file_->sun->irradiance;
    }
    /// [W/m^2] Of the light that a patch sends before any other patch has lit it: its own, and the sun's reflected.
    Rgb first_light(std::uint32_t patch) const { return emittance(patch) + reflectance(patch) * sunlight(patch); }
    /// The same at a point of a side with this normal.
    Rgb sunlight(std::uint32_t surface, Vec3 point, Vec3 normal) const;

    /// Surfaces but for those of the sky, which are the last.
    std::uint32_t own_surfaces() const { return static_cast<std::uint32_t>(file_->own_surfaces()); }
    bool is_sky(std::uint32_t surface) const { return surface >= own_surfaces(); }
    Bounds own_bounds() const; ///< without the sky

    /// The patch on one side of a surface at (u, v), or no_patch for the back of a one-sided surface.
    std::uint32_t patch_at(std::uint32_t surface, double u, double v, bool front) const;
    /// The patches on both sides at (u, v), or `none` for the back of a one-sided surface.
    struct Sides
    {
        std::uint32_t front;
        std::uint32_t back;
    };
    Sides patches_at(std::uint32_t surface, double u, double v, std::uint32_t none) const;
    const Tessellation& tessellation(std::uint32_t surface) const { return tessellations_[surface]; }
    /// The first patch of a side that exists; the others follow.
    std::uint32_t first_patch(std::uint32_t surface, bool front = true) const
    {
        return first_cell_[surface] + (front ? 0 : cell_count_);
    }

    double own_area() const { return own_area_; }                 ///< [m^2] of all sides that exist, without the sky
    double total_area() const { return total_area_; }             ///< [m^2] A_T, of all sides that exist, with the sky
    Rgb lamp_power() const { return lamp_power_; }                ///< [W] of what surfaces emit
    Rgb source_power() const { return lamp_power_ + sun_power_; } ///< [W] Phi_T, with what the sun brings
    /// [1] R_ave, area-weighted mean, sources included, as the paper counts
    Rgb average_reflectance() const { return average_reflectance_; }

private:
    std::uint32_t cell_of(std::uint32_t patch) const { return patch < cell_count_ ? patch : patch - cell_count_; }
    void number_cells();
    void let_the_sun_in(int threads);
    void lay_textures(int threads);

    std::shared_ptr<const SceneFile> file_;
    bool two_sided_ = false;
    double patch_size_ = 0.0;
    std::shared_ptr<const Intersector> intersector_; ///< copies of a scene share it
    Bounds bounds_;
    LargeVector<Tessellation> tessellations_; ///< per surface
    LargeVector<std::uint32_t> first_cell_;   ///< per surface
    LargeVector<double> cell_area_;           ///< per surface [m^2], of whole cells
    LargeVector<std::uint32_t> surface_of_;   ///< per cell
    std::uint32_t cell_count_ = 0;
    std::uint32_t patch_count_ = 0;
    std::uint64_t hash_ = 0;
    double own_area_ = 0.0;
    double total_area_ = 0.0;
    std::vector<Rgb> reflectance_;   ///< [1] per cell; empty if that of materials holds
    std::vector<double> sun_shares_; ///< [1] per patch, of the irradiance of what faces the sun; empty without one
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

// Inline: asked for every crossing of a line.
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

/// The number of cells of whole surfaces, a real number as that of cell_count(); surfaces of the sky are not cut.
double cell_count(const SceneFile& file, double patch_size);

/// Identifies what a result was computed from: geometry, reflectances, emittances, the sun, subdivision and sides, but
/// not names, comments or the spelling of numbers. FNV-1a over 64-bit values, the same on every machine.
std::uint64_t scene_hash(const SceneFile& file, const LargeVector<Tessellation>& tessellations, bool two_sided);

} // namespace multipath
