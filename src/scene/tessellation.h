#pragma once

#include "geometry/surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
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

struct Tessellation;

/// Quadtrees (Samet 1984) in the cells of a grid: a cell may be cut into four similar ones of equal area, and these
/// again. The leaves are numbered cell by cell, and within each cell depth first.
class CellTrees
{
public:
    static constexpr std::uint8_t deepest = 12;

    /// levels: of the leaves in their order, 0 for a whole cell of the grid.
    /// Throws std::invalid_argument if they do not form whole trees, or exceed `deepest` or 2^31 cells of that level.
    CellTrees(const Tessellation& grid, const std::uint8_t* levels, std::size_t count);

    /// True if the cells of a grid can be cut to this level.
    static bool fit(const Tessellation& grid, std::uint8_t level);

    std::uint32_t leaf_count() const { return static_cast<std::uint32_t>(leaves_.size()); }
    std::uint8_t depth() const { return depth_; } ///< highest level
    std::uint8_t level(std::uint32_t leaf) const { return leaves_[leaf].level; }
    /// The number of the leaf as a cell of the grid that is `level` times finer by two.
    std::uint32_t cell_of_level(std::uint32_t leaf) const { return leaves_[leaf].cell; }
    /// The leaf at a place (x, y) of a cell, in units of its edges from its origin.
    std::uint32_t leaf_at(std::uint32_t cell, double x, double y) const;

private:
    struct Leaf
    {
        std::uint32_t cell;
        std::uint8_t level;
    };
    struct Place;
    class Builder;
    static constexpr std::uint32_t inner = 0x80000000u;

    Shape shape_;
    std::uint8_t depth_ = 0;
    /// First of the cells of the grid, then of the parts of each cut cell, four by four: the number of a leaf, or
    /// `inner` and where the parts are.
    std::vector<std::uint32_t> nodes_;
    std::vector<Leaf> leaves_;
};

/// How one surface is cut into patches: a parallelogram into cells_u x cells_v equal parallelograms, a triangle into
/// cells_u^2 triangles similar to it (cells_v = cells_u). Where there are trees, their leaves are the cells. Cell
/// numbers follow from (u, v) in constant time, or in the depth of the tree.
struct Tessellation
{
    Shape shape = Shape::parallelogram;
    std::uint32_t cells_u = 1;
    std::uint32_t cells_v = 1;
    std::shared_ptr<const CellTrees> trees; ///< none if all cells are whole

    std::uint64_t cell_count() const { return trees ? trees->leaf_count() : std::uint64_t{cells_u} * cells_v; }
    /// The cell that holds (u, v); values a rounding error outside the surface count as on its border.
    std::uint32_t cell_at(double u, double v) const;
    std::uint8_t level(std::uint32_t cell) const { return trees ? trees->level(cell) : std::uint8_t{0}; }
    /// Points of the grid of the smallest cells, which has grid_u() steps along u and grid_v() along v.
    CellCorners corners(std::uint32_t cell) const;
    std::uint32_t grid_u() const { return cells_u << depth(); }
    std::uint32_t grid_v() const { return cells_v << depth(); }
    /// The cell as a surface of its own. Cells of one level have the same area, a quarter of that of the level before.
    Surface cell(const Surface& surface, std::uint32_t cell) const;
    /// The whole cells, each cut into 4^level.
    Tessellation uniform(std::uint8_t level) const { return {shape, cells_u << level, cells_v << level, nullptr}; }

    /// Number of cells in the columns of a triangle before column i of n, each of which holds 2 (n - i) - 1.
    static std::uint64_t cells_before_column(std::uint64_t i, std::uint64_t n) { return i * (2 * n - i); }

private:
    std::uint8_t depth() const { return trees ? trees->depth() : std::uint8_t{0}; }
    CellCorners uniform_corners(std::uint32_t cell) const;
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
    if (shape == Shape::parallelogram) {
        const std::uint32_t j = cell_index(v, cells_v);
        const std::uint32_t cell = i * cells_v + j;
        return trees ? trees->leaf_at(cell, u * cells_u - i, v * cells_v - j) : cell;
    }

    const std::uint32_t last = cells_u - 1 - i; // the column's last cell has no upper half
    const std::uint32_t j = std::min(cell_index(v, cells_u), last);
    const double x = u * cells_u - i;
    const double y = v * cells_u - j;
    const bool upper = j < last && x + y > 1.0;
    const std::uint32_t cell = static_cast<std::uint32_t>(cells_before_column(i, cells_u)) + 2 * j + (upper ? 1 : 0);
    if (trees)
        return upper ? trees->leaf_at(cell, 1.0 - x, 1.0 - y) : trees->leaf_at(cell, x, y);
    return cell;
}

inline std::uint32_t CellTrees::leaf_at(std::uint32_t cell, double x, double y) const
{
    std::uint32_t node = nodes_[cell];
    while ((node & inner) != 0) {
        x *= 2.0;
        y *= 2.0;
        std::uint32_t part = (x >= 1.0 ? 2u : 0u) + (y >= 1.0 ? 1u : 0u);
        if (shape_ == Shape::parallelogram || part != 0 || x + y <= 1.0) {
            part = shape_ == Shape::parallelogram || part == 0 ? part : part == 1 ? 2 : 3;
            x -= x >= 1.0 ? 1.0 : 0.0;
            y -= y >= 1.0 ? 1.0 : 0.0;
        } else {
            part = 1; // the middle of a triangle, upside down
            x = 1.0 - x;
            y = 1.0 - y;
        }
        node = nodes_[(node & ~inner) + part];
    }
    return node;
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
