#pragma once

#include "geometry/surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// A point of the grid that cuts a surface: the i-th of cells_u steps along u, the j-th of cells_v along v.
struct GridPoint
{
    std::uint32_t i = 0;
    std::uint32_t j = 0;
};

/// The corners of a cell in turn, counter-clockwise on the front, from its origin along its edge_u.
struct CellCorners
{
    std::array<GridPoint, 4> points;
    std::size_t count = 4; ///< or 3

    const GridPoint* begin() const { return points.data(); }
    const GridPoint* end() const { return points.data() + count; }
};

/// How one surface is cut into equal patches: a parallelogram into cells_u x cells_v parallelograms, a triangle into
/// cells_u^2 triangles similar to it (cells_v = cells_u). Cell numbers follow from (u, v) in constant time.
struct Tessellation
{
    Shape shape = Shape::parallelogram;
    std::uint32_t cells_u = 1;
    std::uint32_t cells_v = 1;

    std::uint64_t cell_count() const { return std::uint64_t{cells_u} * cells_v; }
    /// The cell that holds (u, v); values a rounding error outside the surface count as on its border.
    std::uint32_t cell_at(double u, double v) const;
    CellCorners corners(std::uint32_t cell) const;
    /// The cell as a surface of its own; all cells have the same area.
    Surface cell(const Surface& surface, std::uint32_t cell) const;

    /// Number of cells in the columns of a triangle before column i of n, each of which holds 2 (n - i) - 1.
    static std::uint64_t cells_before_column(std::uint64_t i, std::uint64_t n) { return i * (2 * n - i); }

private:
    static std::uint32_t cell_index(double x, std::uint32_t cells)
    {
        const double place = x * cells;
        return place <= 0.0 ? 0 : std::min(static_cast<std::uint32_t>(place), cells - 1);
    }
};

// Inline: asked for every crossing of a line.
inline std::uint32_t Tessellation::cell_at(double u, double v) const
{
    const std::uint32_t i = cell_index(u, cells_u);
    if (shape == Shape::parallelogram)
        return i * cells_v + cell_index(v, cells_v);

    const std::uint32_t last = cells_u - 1 - i; // the column's last cell has no upper half
    const std::uint32_t j = std::min(cell_index(v, cells_u), last);
    const bool upper = j < last && u * cells_u - i + (v * cells_u - j) > 1.0;
    return static_cast<std::uint32_t>(cells_before_column(i, cells_u)) + 2 * j + (upper ? 1 : 0);
}

/// Cells along an edge = ceil(edge / patch_size), at least one; a triangle is cut by its longest edge.
/// Throws SettingsError when a surface would get 2^31 cells or more.
Tessellation tessellate(const Surface& surface, double patch_size);

/// How many cells all surfaces get; a real number, since a small patch size gives more than an integer holds.
double cell_count(const SurfaceList& surfaces, double patch_size);

/// A patch size [scene units] that gives a few thousand patches: the largest round number not above sqrt(A / 2500), or
/// up to 2.5 times as much if it takes that to stay below 4000 patches.
double default_patch_size(const SurfaceList& surfaces);

/// The patch size [scene units] that cuts the surfaces into a number of patches close to `wanted`, never above it
/// unless the surfaces alone are more.
double patch_size_for_count(const SurfaceList& surfaces, std::uint64_t wanted);

} // namespace multipath
