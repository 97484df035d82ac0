#pragma once

#include "scene/rgb.h"
#include "scene/tessellation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

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

} // namespace multipath
