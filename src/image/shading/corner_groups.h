#pragma once

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

/// One corner of one cell: number 0 ... 3 counter-clockwise from the cell's origin, 0 ... 2 of a triangle.
struct CellCorner
{
    std::uint32_t cell;
    std::uint32_t number;
};

/// The corners of the cells of one surface. Corner (i, j) lies at u = i / cells_u, v = j / cells_v.
class CornerLattice
{
public:
    static constexpr std::size_t per_cell = 4; ///< places for the corners of a cell; a triangle uses three

    explicit CornerLattice(const Tessellation& tessellation) : tessellation_(tessellation) {}

    std::uint32_t last_column(std::uint32_t j) const { return cells_u() - (triangle() ? j : 0); }
    std::uint32_t last_row() const { return tessellation_.cells_v; }
    double u(std::uint32_t i) const { return static_cast<double>(i) / tessellation_.cells_u; }
    double v(std::uint32_t j) const { return static_cast<double>(j) / tessellation_.cells_v; }

    /// The cells that meet at corner (i, j), in the order of a turn around it: four, or six of a triangle, of which
    /// some do not exist at the border. The last one's next is the first. On a parallelogram the cells differ in i and
    /// j by turns: next to an even one lies the one with the same j.
    std::array<std::optional<CellCorner>, 6> around(std::uint32_t i, std::uint32_t j) const;
    std::size_t most_around() const { return triangle() ? 6 : 4; }

    /// The cell of a parallelogram that lies so many steps along u and v from another one, if it exists.
    std::optional<std::uint32_t> cell_beside(std::uint32_t cell, int along_u, int along_v) const;

    /// Between the corners of the cell at (u, v): bilinear, or barycentric on a triangle. `values`: per_cell for each
    /// cell.
    Rgb interpolated(const Rgb* values, double u, double v) const;

private:
    bool triangle() const { return tessellation_.shape == Shape::triangle; }
    std::uint32_t cells_u() const { return tessellation_.cells_u; }
    std::optional<std::uint32_t> rectangle(std::int64_t i, std::int64_t j) const;
    std::optional<std::uint32_t> upright_triangle(std::int64_t i, std::int64_t j) const;
    std::optional<std::uint32_t> turned_triangle(std::int64_t i, std::int64_t j) const;

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
};

/// The groups at the corners of one side of a surface, for the rows first_row ... end_row - 1 of its lattice. A value
/// is the mean of the patches of the group. Where a group ends, at the border or at something that stands there, the
/// values of a parallelogram are extrapolated linearly.
std::vector<CornerGroup> corner_groups(const VisiblePatches& patches, std::uint32_t surface, bool front,
                                       std::uint32_t first_row, std::uint32_t end_row, bool with_points);

} // namespace multipath
