#pragma once

#include "geometry/vec3.h"
#include "image/shading/corner_groups.h"
#include "image/shading/visible_patches.h"
#include "scene/rgb.h"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
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
    /// `normals`: unit front normals of all surfaces. The arguments and the scene must outlive this object.
    FlatRegions(const VisiblePatches& patches, const std::vector<Vec3>& normals);

    /// True if the surface belongs to a region. A region has at least two surfaces, and the grid cells of at least one
    /// of them are needles.
    bool contains(std::uint32_t surface) const { return region_of_[surface] != none; }

    /// Value at the corner of a group on a surface for which contains() is true, by moving least squares (Lancaster and
    /// Salkauskas 1981): a linear fit to the nearby patches of the region, clamped to the range of their values.
    /// Patches that are occluded from the first patch of the group are left out. Returns nothing if no patch is left.
    std::optional<Rgb> value(const CornerGroup& group) const;

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    using Square = std::array<std::int64_t, 4>; ///< region, side, row, column

    /// One side of a region, with a grid of squares in its plane.
    struct Plane
    {
        std::uint32_t region;
        bool front;
        double reach;        ///< [scene units] radius of the fit
        Vec3 axis_u, axis_v; ///< unit vectors

        Square square(Vec3 point) const; ///< the square that contains a point
    };

    /// Sums over the patches whose centres lie in one square. The fit at a corner then costs the same however small the
    /// patches are.
    struct Bin
    {
        double weight = 0.0; ///< [m^2] sum of the open areas
        Vec3 centre;         ///< [m^3] sum of weight * centre
        Rgb value;           ///< sum of weight * value
        Vec3 point;          ///< an uncovered point of one of the patches
    };

    Plane plane_of(std::uint32_t surface, bool front) const;
    void add(std::uint32_t surface, bool front);

    const VisiblePatches& patches_;
    const std::vector<Vec3>& normals_;
    std::vector<std::uint32_t> region_of_; ///< per surface: the first surface of its region, or `none`
    std::vector<double> reach_;            ///< [scene units] of each region, at the index of its first surface
    std::map<Square, Bin> bins_;
};

} // namespace multipath
