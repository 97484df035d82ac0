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
    Scene refined(const std::vector<std::uint8_t>& levels) const;
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
    double area(std::uint32_t patch) const;                                               ///< [m^2]
    std::vector<double> areas() const;                                                    ///< [m^2] of all patches
    Rgb reflectance(std::uint32_t patch) const { return material_of(patch).reflectance; } ///< [1]
    /// [W/m^2]; only fronts emit
    Rgb emittance(std::uint32_t patch) const { return is_front(patch) ? material_of(patch).emittance : Rgb{}; }

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

    double total_area() const { return total_area_; }  ///< [m^2] A_T, of all sides that exist
    Rgb source_power() const { return source_power_; } ///< [W] Phi_T
    /// [1] R_ave, area-weighted mean, sources included, as the paper counts
    Rgb average_reflectance() const { return average_reflectance_; }

private:
    std::uint32_t cell_of(std::uint32_t patch) const { return patch < cell_count_ ? patch : patch - cell_count_; }
    void number_cells();

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
    double total_area_ = 0.0;
    Rgb source_power_;
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

/// Identifies what a result was computed from: geometry, reflectances, emittances, subdivision and sides, but not
/// names, comments or the spelling of numbers. FNV-1a over 64-bit values, the same on every machine.
std::uint64_t scene_hash(const SceneFile& file, const LargeVector<Tessellation>& tessellations, bool two_sided);

} // namespace multipath
