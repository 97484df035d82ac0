#pragma once

#include "geometry/bounds.h"
#include "scene/scene_file.h"
#include "scene/tessellation.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace multipath {

class Intersector;

/// A patch: one side of a cell of a surface (see Tessellation; if quadtrees subdivide the surface, their leaves are its
/// cells).
struct Patch
{
    std::uint32_t surface = 0; ///< index of the surface that the patch is part of
    Surface shape;             ///< the patch as a surface of its own, whose front is the side of the patch
};

/// A scene ready for solving: surfaces for intersection, patches for radiosity. Immutable. Every surface is divided
/// into cells (tessellation.h). The front of each cell is a patch; in a two-sided scene its back is another one.
/// Patches are numbered surface by surface, on each surface in the order of its cells. In a two-sided scene all front
/// patches come before all back patches.
class Scene
{
public:
    static constexpr std::uint32_t no_patch = 0xffffffffu;

    /// Divides every surface into cells with edges of at most patch_size [scene units], up to rounding; each surface of
    /// the sky is one cell. Throws InputError for a scene without surfaces, or with neither an emitter nor a sun, and
    /// SettingsError if there would be 2^31 patches or more.
    Scene(SceneFile file, double patch_size, bool two_sided = false, int threads = 1);
    Scene(std::shared_ptr<const SceneFile> file, double patch_size, bool two_sided, int threads);

    /// The same scene with the cells of its grids subdivided by new quadtrees, which replace any earlier ones. `levels`
    /// holds the level of each leaf, surface after surface including the sky, in the order of the leaves (see
    /// CellTrees); a grid cell that is not divided is a leaf of level 0. Throws std::invalid_argument if the levels do
    /// not form complete trees that fit the grids, SettingsError if there would be 2^31 patches or more.
    Scene refined(const std::vector<std::uint8_t>& levels, int threads = 1) const;
    /// The levels of all leaves, in the order of refined(). Empty if no cell is subdivided; refined() does not accept
    /// an empty list.
    std::vector<std::uint8_t> levels() const;

    const std::string& path() const { return file_->path; }
    const std::vector<Material>& materials() const { return file_->materials; }
    const SurfaceList& surfaces() const { return file_->surfaces; }
    const SceneFile& file() const { return *file_; }
    std::shared_ptr<const SceneFile> shared_file() const { return file_; } ///< for owners that outlive the scene
    const Intersector& intersector() const { return *intersector_; }
    const Bounds& bounds() const { return bounds_; } ///< of all surfaces, with the sky
    bool two_sided() const { return two_sided_; }
    double patch_size() const { return patch_size_; } ///< [scene units]
    std::uint64_t hash() const { return hash_; }      ///< see scene_hash()

    std::uint32_t patch_count() const { return patch_count_; }
    std::uint32_t surface_of(std::uint32_t patch) const { return surface_of_[cell_of(patch)]; }
    /// True if the patch is the front of its cell.
    bool is_front(std::uint32_t patch) const { return patch < cell_count_; }
    /// The corners of a patch on the finest grid of its surface, of grid_u() x grid_v() steps (see
    /// Tessellation::corners). A back patch has the corners of its front patch in the same order, clockwise seen from
    /// the back.
    CellCorners corners(std::uint32_t patch) const
    {
        const std::uint32_t surface = surface_of(patch);
        return tessellations_[surface].corners(cell_of(patch) - first_cell_[surface]);
    }
    const Material& surface_material(std::uint32_t surface) const { return file_->materials[file_->material[surface]]; }
    const Material& material_of(std::uint32_t patch) const { return surface_material(surface_of(patch)); }
    Patch patch(std::uint32_t patch) const;
    double area(std::uint32_t patch) const; ///< [m^2]
    std::vector<double> areas() const;      ///< [m^2] areas of all patches, by patch
    /// [m^2] Weights of all patches in means over the scene, by patch: their areas, but 0 for the sky.
    std::vector<double> weights() const;
    Rgb reflectance(std::uint32_t patch) const ///< [1] of a patch; on a textured surface the mean over the patch
    {
        return reflectance_.empty() ? material_of(patch).reflectance : reflectance_[cell_of(patch)];
    }
    /// [1] Reflectance at the point (u, v) of a surface. A texture is interpolated between its pixels; without texture
    /// coordinates its mean counts.
    Rgb reflectance_at(std::uint32_t surface, double u, double v) const;
    /// True if the surface is textured and has texture coordinates. Any other surface has one colour.
    bool shows_texture(std::uint32_t surface) const
    {
        return is_textured(surface) && file().texture_frames[surface].known;
    }
    bool is_textured(std::uint32_t surface) const { return surface_material(surface).texture != Material::no_texture; }
    /// [W/m^2] Emittance of a patch; 0 for a back patch, since only fronts emit.
    Rgb emittance(std::uint32_t patch) const { return is_front(patch) ? material_of(patch).emittance : Rgb{}; }

    /// [W/m^2] Irradiance from the sun, with shadows, averaged over the patch; 0 without a sun.
    Rgb sunlight(std::uint32_t patch) const
    {
        return sun_shares_.empty() ? Rgb{} : sun_shares_[patch] * file_->sun->irradiance;
    }
    /// [W/m^2] Radiosity before any light is exchanged between patches: emitted light and reflected sunlight.
    Rgb first_light(std::uint32_t patch) const { return emittance(patch) + reflectance(patch) * sunlight(patch); }
    /// [W/m^2] Irradiance from the sun, with shadows, at a point, on the side to which the unit normal points; 0
    /// without a sun and on the sky. `surface` is the surface that the point lies on, or Intersector::no_surface.
    Rgb sunlight(std::uint32_t surface, Vec3 point, Vec3 normal) const;

    /// Number of surfaces without those of the sky, which have the highest indices.
    std::uint32_t own_surfaces() const { return static_cast<std::uint32_t>(file_->own_surfaces()); }
    bool is_sky(std::uint32_t surface) const { return surface >= own_surfaces(); }
    bool is_sky_patch(std::uint32_t patch) const { return is_sky(surface_of(patch)); }
    Bounds own_bounds() const; ///< of the surfaces without the sky

    /// The patch at (u, v) on the front or the back of a surface; no_patch for the back in a one-sided scene.
    std::uint32_t patch_at(std::uint32_t surface, double u, double v, bool front) const;
    /// The patches at (u, v) on both sides of a surface. In a one-sided scene `back` is `none`.
    struct Sides
    {
        std::uint32_t front;
        std::uint32_t back;
    };
    Sides patches_at(std::uint32_t surface, double u, double v, std::uint32_t none) const;
    const Tessellation& tessellation(std::uint32_t surface) const { return tessellations_[surface]; }
    /// The first patch on the front or the back of a surface; the other patches of this side follow it. A one-sided
    /// scene has no back patches.
    std::uint32_t first_patch(std::uint32_t surface, bool front = true) const
    {
        return first_cell_[surface] + (front ? 0 : cell_count_);
    }

    double own_area() const { return own_area_; }     ///< [m^2] of all sides with patches, without the sky
    double total_area() const { return total_area_; } ///< [m^2] A_T, of all sides with patches, with the sky
    Rgb lamp_power() const { return lamp_power_; }    ///< [W] emitted by surfaces without the sky
    Rgb sun_power() const { return sun_power_; }      ///< [W] sunlight that arrives
    /// [W] Phi_T: the power of lamps and sky, and the sunlight that arrives.
    Rgb source_power() const { return lamp_power_ + sky_power_ + sun_power_; }
    /// [1] R_ave: mean over all sides with patches, weighted by area. Emitters are included, as in the paper, and so is
    /// the sky.
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
    LargeVector<std::uint32_t> first_cell_;   ///< per surface: index of its first cell
    LargeVector<double> cell_area_;           ///< per surface: [m^2] area of a cell of the grid, before subdivision
    LargeVector<std::uint32_t> surface_of_;   ///< per cell: index of its surface
    std::uint32_t cell_count_ = 0;            ///< number of cells, which is the number of front patches
    std::uint32_t patch_count_ = 0;
    std::uint64_t hash_ = 0;
    double own_area_ = 0.0;
    double total_area_ = 0.0;
    std::vector<Rgb> reflectance_;   ///< [1] per cell; empty if no material is textured
    std::vector<double> sun_shares_; ///< [1] per patch: sunlight() / sun->irradiance; empty without a sun
    Rgb lamp_power_;
    Rgb sky_power_;
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

/// The number of cells of a scene at this patch size [scene units], with one for each surface of the sky. A real
/// number, since a small patch size gives more cells than an integer holds.
double cell_count(const SceneFile& file, double patch_size);

/// Hash of all that a result depends on: geometry, order of the surfaces, reflectances, emittances, textures, the sun,
/// subdivision, and whether backs have patches; but not names, comments or the spelling of numbers. A chain of
/// mix_bits() over 64-bit values, the same on every machine.
std::uint64_t scene_hash(const SceneFile& file, const LargeVector<Tessellation>& tessellations, bool two_sided);

} // namespace multipath
