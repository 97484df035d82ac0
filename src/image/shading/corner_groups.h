#pragma once

#include "image/shading/patch_slopes.h"
#include "image/shading/smoothing_groups.h"
#include "image/shading/visible_patches.h"
#include "scene/rgb.h"
#include "scene/tessellation.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// A cell of a tessellation (tessellation.h; where quadtrees divide the grid, the cells are their leaves) and the index
/// of one of its corners: 0 ... 3, or 0 ... 2 in a triangle, counter-clockwise from the origin of the cell. The index
/// `on_edge` marks a hanging node: a corner of smaller cells that lies inside an edge of this cell.
struct CellCorner
{
    static constexpr std::uint32_t on_edge = 4;

    std::uint32_t cell;
    std::uint32_t number;
};

/// The corners of the cells of one surface. Corner (i, j) lies at u = i / grid_u, v = j / grid_v, on the grid of the
/// smallest cells of the tessellation.
class CornerLattice
{
public:
    static constexpr std::size_t per_cell = 4; ///< slots per cell in arrays of corner values; a triangle uses three

    explicit CornerLattice(const Tessellation& tessellation) : tessellation_(tessellation) {}

    double u(GridPoint corner) const { return static_cast<double>(corner.i) / tessellation_.grid_u(); }
    double v(GridPoint corner) const { return static_cast<double>(corner.j) / tessellation_.grid_v(); }

    /// All corners, each once, row by row and by increasing i.
    std::vector<GridPoint> points() const;

    /// The four cells around a corner, or six in a triangle, counter-clockwise. Those beyond the border of the surface
    /// are empty. In a parallelogram, cells 0 and 1 lie below the corner (smaller v), cells 2 and 3 above. A cell that
    /// has the corner as a hanging node appears twice (a triangle: three times).
    std::vector<std::optional<CellCorner>> around(GridPoint corner) const;

    /// Interpolates between the corners of the cell at (u, v): bilinear in a parallelogram, barycentric in a triangle.
    /// `values`: per_cell entries for each cell, in the order of the cells.
    Rgb interpolated(const Rgb* values, double u, double v) const;

private:
    bool triangle() const { return tessellation_.shape == Shape::triangle; }
    std::optional<CellCorner> cell_at(std::int64_t i, std::int64_t j, bool upper, GridPoint corner) const;

    Tessellation tessellation_;
};

/// Patches on one side of a surface that meet at a corner without an occluder between them. The patches share one value
/// at the corner.
struct CornerGroup
{
    std::uint32_t surface = 0;
    bool front = true;
    Vec3 normal; ///< unit normal of the side
    Vec3 corner;
    /// CornerLattice::per_cell * patch + index of the corner in the patch. Patches in which the corner is a hanging
    /// node are left out.
    std::vector<std::size_t> slots;
    Rgb value;
    double weight = 0.0;    ///< [1] sum of the open shares (VisiblePatches) of the patches in `slots`
    bool on_border = false; ///< the corner lies on the border of the surface
    /// Uncovered points of each patch, one near the corner and one near the centre of the patch, as far as they exist.
    /// Empty for corners inside the surface.
    std::vector<OpenPoint> points;

    /// An edge of a larger patch of the group, inside which the corner lies as a hanging node.
    struct Edge
    {
        std::size_t from;   ///< slot of the value at the start of the edge
        std::size_t to;     ///< slot of the value at the end of the edge
        double share;       ///< [1] position of the corner along the edge
        std::uint8_t level; ///< quadtree level of the larger patch
    };
    std::optional<Edge> edge; ///< if set, the final value is interpolated between the ends of this edge
};

/// The groups at the corners of one side of a surface. The value of a group is the mean of the linear functions of its
/// patches at the corner, each at least 0, weighted by the open shares of the patches. A group of weight 0 gets the
/// mean of the other groups at the corner.
std::vector<CornerGroup> corner_groups(const VisiblePatches& patches, const std::vector<PatchSlope>& slopes,
                                       std::uint32_t surface, bool front);

} // namespace multipath
