#pragma once

#include "geometry/vec3.h"
#include "image/shading/smoothing_groups.h"
#include "image/shading/visible_patches.h"
#include "scene/rgb.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace multipath {

/// Flat polygons that the scene file splits into needle-shaped faces, as triangulation does with walls that have
/// windows. Patches of needles are slender: each gets few lines, and its corners lie far from its centre. If every
/// patch were shaded by itself, such patches would show as streaks. Faces of one material that share edges in one plane
/// therefore form one region. Sources belong to no region. The value at a corner is fitted to all patches of the region
/// within a radius: the longest edge of all grid cells (tessellation.h) of the region, before quadtrees divide them.
class FlatRegions
{
public:
    /// `patches` and its scene must outlive this object.
    FlatRegions(const VisiblePatches& patches, int threads);

    /// True if the surface belongs to a region. A region has at least two surfaces, and the grid cells of at least one
    /// of them are needles.
    bool contains(std::uint32_t surface) const { return region_of_[surface] != none; }

    /// Value at `corner` of a surface for which contains() is true, by moving least squares (Lancaster and Salkauskas
    /// 1981): a linear fit to the nearby patches of the region, clamped to the range of their values. Patches that are
    /// occluded from `own` are left out; `own` is an uncovered point on the same side near the corner. Returns nothing
    /// if no patch is left.
    std::optional<Rgb> value(std::uint32_t surface, bool front, Vec3 corner, const OpenPoint& own) const;

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// Sums over the patches whose centres lie in one square of the grid of a region.
    struct Bin
    {
        double weight = 0.0; ///< [m^2] sum of the open areas
        Vec3 centre;         ///< [m^3] sum of weight * centre
        Rgb value;           ///< sum of weight * value
        Vec3 point;          ///< an uncovered point of one of the patches
    };
    /// A region with a grid of bins for its front and, in a two-sided scene, one for its back.
    struct Region
    {
        Vec3 origin;
        Vec3 axis_u, axis_v; ///< unit vectors
        double reach = 0.0;  ///< [scene units] radius of the fit
        double cell = 0.0;   ///< [scene units] side of a square of the grid
        std::size_t columns = 0;
        std::size_t rows = 0;
        /// Index in bins_ of the first bin of the front; the bins of the back follow those of the front.
        std::size_t first_bin = 0;

        std::size_t bin(std::size_t i, std::size_t j, bool front) const
        {
            return first_bin + (front ? 0 : columns * rows) + j * columns + i;
        }
        std::size_t column(Vec3 point) const { return index(dot(point - origin, axis_u), columns); }
        std::size_t row(Vec3 point) const { return index(dot(point - origin, axis_v), rows); }
        std::size_t index(double x, std::size_t count) const;
    };

    void add_region(const std::vector<std::uint32_t>& surfaces);
    void fill(const Region& region, std::uint32_t surface, bool front);

    const VisiblePatches& patches_;
    std::vector<Vec3> normals_;            ///< per surface
    std::vector<std::uint32_t> region_of_; ///< per surface: index in regions_, or `none`
    std::vector<Region> regions_;
    std::vector<Bin> bins_;
};

} // namespace multipath
