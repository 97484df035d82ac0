#pragma once

#include "image/shading/patch_slopes.h"
#include "image/shading/skin.h"
#include "image/shading/visible_patches.h"
#include "scene/rgb.h"
#include "scene/tessellation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// One corner of one cell: number 0 ... 3 counter-clockwise from the cell's origin, 0 ... 2 of a triangle; or a corner
/// of smaller cells on an edge of this one.
struct CellCorner
{
    static constexpr std::uint32_t on_edge = 4;

    std::uint32_t cell;
    std::uint32_t number;
};

/// The corners of the cells of one surface. Corner (i, j) lies at u = i / grid_u, v = j / grid_v of the tessellation.
class CornerLattice
{
public:
    static constexpr std::size_t per_cell = 4; ///< places for the corners of a cell; a triangle uses three

    explicit CornerLattice(const Tessellation& tessellation) : tessellation_(tessellation) {}

    std::uint32_t last_column(std::uint32_t j) const { return tessellation_.grid_u() - (triangle() ? j : 0); }
    std::uint32_t last_row() const { return tessellation_.grid_v(); }
    double u(std::uint32_t i) const { return static_cast<double>(i) / tessellation_.grid_u(); }
    double v(std::uint32_t j) const { return static_cast<double>(j) / tessellation_.grid_v(); }

    /// In rows first_row ... end_row - 1, row by row; each once.
    std::vector<GridPoint> points(std::uint32_t first_row, std::uint32_t end_row) const;

    /// The cells that meet at corner (i, j), in the order of a turn around it: four, or six of a triangle, of which
    /// some do not exist at the border. The last one's next is the first. On a parallelogram the cells differ in i and
    /// j by turns: next to an even one lies the one with the same j.
    std::array<std::optional<CellCorner>, 6> around(std::uint32_t i, std::uint32_t j) const;
    std::size_t most_around() const { return triangle() ? 6 : 4; }

    /// Between the corners of the cell at (u, v): bilinear, or barycentric on a triangle. `values`: per_cell for each
    /// cell.
    Rgb interpolated(const Rgb* values, double u, double v) const;

private:
    bool triangle() const { return tessellation_.shape == Shape::triangle; }
    std::optional<CellCorner> cell_at(std::int64_t i, std::int64_t j, bool upper, GridPoint corner) const;

    Tessellation tessellation_;
};

/// Patches of one side of one surface that meet at a corner and have nothing between them: they share one value there.
struct CornerGroup
{
    std::uint32_t surface = 0;
    Vec3 normal; ///< of the side
    Vec3 corner;
    std::vector<std::size_t> places; ///< CornerLattice::per_cell * patch + number of the corner
    Rgb value;
    double weight = 0.0; ///< open shares of the patches, added up
    /// In the open, by turns close to the corner and to the middle of a cell; on a border, or if asked for.
    std::vector<OpenPoint> points;
    bool on_border = false; ///< of the surface

    /// The edge of a larger patch of the group on which the corner lies: it has the value that this edge has there.
    struct Edge
    {
        std::size_t from; ///< places of its ends
        std::size_t to;
        double share;       ///< of the way
        std::uint8_t level; ///< of the larger patch
    };
    std::optional<Edge> edge;
};

/// The groups at the corners of one side of a surface, for the rows first_row ... end_row - 1 of its lattice. A value
/// is the mean of what the linear functions of the patches have there.
std::vector<CornerGroup> corner_groups(const VisiblePatches& patches, const std::vector<PatchSlope>& slopes,
                                       std::uint32_t surface, bool front, std::uint32_t first_row,
                                       std::uint32_t end_row, bool with_points);

} // namespace multipath
