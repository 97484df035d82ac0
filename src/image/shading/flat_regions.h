#pragma once

#include "geometry/vec3.h"
#include "image/shading/skin.h"
#include "image/shading/visible_patches.h"
#include "scene/rgb.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace multipath {

/// Flat polygons that a scene file cuts into needles, as triangulation does with walls that have windows. Patches of
/// needles are slender, so that each gets few lines and its corners lie far from its middle; shaded one by one, they
/// show as streaks. Here faces of one material in one plane that share edges are one region, of which the values at
/// places are fitted to all patches around, as far as a patch that is no needle would reach.
class FlatRegions
{
public:
    /// The patches must outlive this object.
    FlatRegions(const VisiblePatches& patches, int threads);

    /// True if the surface belongs to a region with needles.
    bool hold(std::uint32_t surface) const { return region_of_[surface] != none; }

    /// At `corner` of a surface that belongs to a region: a linear fit by weighted least squares to the patches around
    /// that can be seen from `own`, a point of the same side in the open close to the corner. Nothing if there are
    /// none.
    std::optional<Rgb> value(std::uint32_t surface, bool front, Vec3 corner, const OpenPoint& own) const;

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// Sums over the patches in one cell of a region's grid.
    struct Bin
    {
        double weight = 0.0; ///< open area
        Vec3 place;          ///< [weight * scene units]
        Rgb value;           ///< [weight * value]
        Vec3 point;          ///< in the open
    };
    /// A region with a grid of bins on each side that exists.
    struct Region
    {
        Vec3 origin;
        Vec3 axis_u, axis_v; ///< unit vectors
        double reach = 0.0;  ///< [scene units] the longest edge of a patch
        double cell = 0.0;   ///< [scene units]
        std::size_t columns = 0;
        std::size_t rows = 0;
        std::size_t first_bin = 0; ///< of the front; the back's follow

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
    std::vector<Vec3> normals_;            ///< of all surfaces
    std::vector<std::uint32_t> region_of_; ///< per surface
    std::vector<Region> regions_;
    std::vector<Bin> bins_;
};

} // namespace multipath
