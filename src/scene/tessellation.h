#pragma once

#include "geometry/surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace multipath {

/// A corner point of a grid on a surface: i steps along u and j along v. The grid of a Tessellation has cells_u by
/// cells_v steps. Points from Tessellation::corners() count steps of the finest grid, grid_u() by grid_v().
struct GridPoint
{
    std::uint32_t i = 0;
    std::uint32_t j = 0;
};

/// The corners of a cell, counter-clockwise seen from the front. Parallelogram: its origin, the end of its edge_u, the
/// opposite corner, the end of its edge_v. Triangle: its origin, the end of its edge_u, the end of its edge_v.
struct CellCorners
{
    std::array<GridPoint, 4> points;
    std::size_t count = 4; ///< or 3

    const GridPoint* begin() const { return points.data(); }
    const GridPoint* end() const { return points.data() + count; }
};

/// A cell of a grid: its column and row, and for triangles its half of the grid square.
struct GridCell
{
    std::uint32_t i;
    std::uint32_t j;
    bool upper = false; ///< upside down; its origin is (i + 1, j + 1)
};

struct Tessellation;

/// One quadtree (Samet 1984) per cell of a grid: a cell is divided into four similar cells of equal area, recursively.
/// The leaves are numbered cell by cell, and depth first within a cell. The four parts of a parallelogram are ordered
/// (low u, low v), (low u, high v), (high u, low v), (high u, high v). Those of a triangle lie at its origin, in its
/// middle, at the end of its edge_v and at the end of its edge_u.
class CellTrees
{
public:
    static constexpr std::uint8_t deepest = 12;

    /// `levels`: one per leaf, in the order of the leaves; 0 for a cell of the grid that is not divided. Throws
    /// std::invalid_argument if the levels do not form complete trees or do not fit the grid (see fit()).
    CellTrees(const Tessellation& grid, const std::uint8_t* levels, std::size_t count);

    /// True if the cells of the grid can be divided to this level: it is at most `deepest`, and the grid would have
    /// fewer than 2^31 cells of that level.
    static bool fit(const Tessellation& grid, std::uint8_t level);

    std::uint32_t leaf_count() const { return static_cast<std::uint32_t>(leaves_.size()); }
    std::uint8_t depth() const { return depth_; } ///< highest level
    std::uint8_t level(std::uint32_t leaf) const { return leaves_[leaf].level; }
    /// The index of the cell of Tessellation::uniform(level(leaf)) that coincides with this leaf.
    std::uint32_t cell_of_level(std::uint32_t leaf) const { return leaves_[leaf].cell; }
    /// The leaf that contains a point of cell `cell` of the grid. (x, y) is measured from the cell's origin along its
    /// edges, whose lengths count as 1.
    std::uint32_t leaf_at(std::uint32_t cell, double x, double y) const;

private:
    struct Leaf
    {
        std::uint32_t cell;
        std::uint8_t level;
    };
    /// Adds the subtree of a cell, whose root is nodes_[node] and whose first leaf is the next one.
    void add_tree(const Tessellation& grid, GridCell cell, std::uint8_t level, std::size_t node,
                  const std::uint8_t* levels, std::size_t count);
    static constexpr std::uint32_t inner = 0x80000000u;

    Shape shape_;
    std::uint8_t depth_ = 0;
    /// The cells of the grid, then the parts of each divided cell, in groups of four. A node is the index of a leaf, or
    /// `inner` | index of its first part.
    std::vector<std::uint32_t> nodes_;
    std::vector<Leaf> leaves_;
};

/// The subdivision of a surface into cells: of a parallelogram into cells_u x cells_v equal parallelograms, of a
/// triangle into cells_u^2 triangles similar to it (cells_v = cells_u). If there are trees, a "cell" below is one of
/// their leaves, and a "cell of the grid" is the root of a tree. The cell at (u, v) is found in constant time, or in
/// time proportional to the depth of its tree.
struct Tessellation
{
    Shape shape = Shape::parallelogram;
    std::uint32_t cells_u = 1;
    std::uint32_t cells_v = 1;
    std::shared_ptr<const CellTrees> trees; ///< null if no cell of the grid is divided

    std::uint64_t cell_count() const { return trees ? trees->leaf_count() : std::uint64_t{cells_u} * cells_v; }
    /// The cell that contains (u, v). A point that rounding put just outside the surface belongs to the nearest cell at
    /// the border.
    std::uint32_t cell_at(double u, double v) const;
    std::uint8_t level(std::uint32_t cell) const { return trees ? trees->level(cell) : std::uint8_t{0}; }
    /// The corners of a cell of any level, as points of the finest grid, which has grid_u() by grid_v() steps.
    CellCorners corners(std::uint32_t cell) const;
    std::uint32_t grid_u() const { return cells_u << depth(); }
    std::uint32_t grid_v() const { return cells_v << depth(); }
    /// The cell as a surface. All cells of a level have the same area, a quarter of the area of a cell one level lower
    /// (level - 1).
    Surface cell(const Surface& surface, std::uint32_t cell) const;
    /// The grid with each of its cells divided into 4^level, without trees.
    Tessellation uniform(std::uint8_t level) const { return {shape, cells_u << level, cells_v << level, nullptr}; }

    GridCell grid_cell(std::uint32_t cell) const;     ///< of the grid without its trees
    std::uint32_t number(const GridCell& cell) const; ///< the inverse of grid_cell()

    /// Number of cells of a triangle in the columns before column i of n; column i has 2 (n - i) - 1 cells.
    static std::uint64_t cells_before_column(std::uint64_t i, std::uint64_t n) { return i * (2 * n - i); }

private:
    std::uint8_t depth() const { return trees ? trees->depth() : std::uint8_t{0}; }
    static std::uint32_t cell_index(double x, std::uint32_t cells)
    {
        const double position = x * cells;
        return position <= 0.0 ? 0 : std::min(static_cast<std::uint32_t>(position), cells - 1);
    }
};

// Inline: called for every intersection of a line.
inline std::uint32_t Tessellation::cell_at(double u, double v) const
{
    const std::uint32_t i = cell_index(u, cells_u);
    if (shape == Shape::parallelogram) {
        const std::uint32_t j = cell_index(v, cells_v);
        const std::uint32_t cell = i * cells_v + j;
        return trees ? trees->leaf_at(cell, u * cells_u - i, v * cells_v - j) : cell;
    }

    const std::uint32_t last = cells_u - 1 - i; // the last grid square of the column has only its lower triangle
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
    // Parts of a triangle: 0 at its origin, 1 in its middle, 2 at the end of its edge_v, 3 at the end of its edge_u.
    while ((node & inner) != 0) {
        x *= 2.0;
        y *= 2.0;
        std::uint32_t part = (x >= 1.0 ? 2u : 0u) + (y >= 1.0 ? 1u : 0u);
        if (shape_ == Shape::parallelogram || part != 0 || x + y <= 1.0) {
            part = shape_ == Shape::parallelogram || part == 0 ? part : part == 1 ? 2 : 3;
            x -= x >= 1.0 ? 1.0 : 0.0;
            y -= y >= 1.0 ? 1.0 : 0.0;
        } else {
            part = 1; // upside down
            x = 1.0 - x;
            y = 1.0 - y;
        }
        node = nodes_[(node & ~inner) + part];
    }
    return node;
}

/// Divides a surface into a grid with ceil(edge / patch_size) cells along an edge, at least one. All three edges of a
/// triangle are divided into the number of cells that its longest edge needs. `patch_size`: [scene units]. Throws
/// SettingsError if the surface would get 2^31 cells or more.
Tessellation tessellate(const Surface& surface, double patch_size);

/// The number of cells that tessellate() would give all surfaces together; a double, since a small patch size
/// [scene units] gives more than an integer holds.
double cell_count(const SurfaceList& surfaces, double patch_size);

/// The default patch size [scene units], a round number: 1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of ten.
/// The search starts at the largest round number up to s = sqrt(A / 2500), where A is the total area; this size gives
/// at least about 2500 patches. While there are more than 4000 patches, the next larger round number is tried, but none
/// above 3 s. If there are then still more than 2^17 + 8 * (number of surfaces) patches, the search goes on, also
/// beyond 3 s, until there are no more than that.
double default_patch_size(const SurfaceList& surfaces);

/// The smallest patch size [scene units], found by bisection, that gives at most `wanted` patches. If there are more
/// surfaces than `wanted`, no size does, and the result is the diagonal of the scene, which gives one patch per
/// surface.
double patch_size_for_count(const SurfaceList& surfaces, std::uint64_t wanted);

} // namespace multipath
