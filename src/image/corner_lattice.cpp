#include "image/corner_lattice.h"

#include <algorithm>

namespace multipath {

namespace {

std::optional<CellCorner> corner_of(std::optional<std::uint32_t> cell, std::uint32_t number)
{
    return cell ? std::optional<CellCorner>({*cell, number}) : std::nullopt;
}

Rgb blend(double share, Rgb a, Rgb b)
{
    return (1.0 - share) * a + share * b;
}

/// The cell that a coordinate in [0, cells] falls into; the far border belongs to the last cell.
std::uint32_t cell_of(double scaled, std::uint32_t cells)
{
    return static_cast<std::uint32_t>(std::clamp(scaled, 0.0, cells - 1.0));
}

} // namespace

std::array<std::optional<CellCorner>, 6> CornerLattice::around(std::uint32_t i, std::uint32_t j) const
{
    const std::int64_t x = i;
    const std::int64_t y = j;
    if (!triangle())
        return {corner_of(rectangle(x - 1, y - 1), 2), corner_of(rectangle(x, y - 1), 3), corner_of(rectangle(x, y), 0),
                corner_of(rectangle(x - 1, y), 1)};
    return {corner_of(upright_triangle(x, y), 0),     corner_of(turned_triangle(x - 1, y), 2),
            corner_of(upright_triangle(x - 1, y), 1), corner_of(turned_triangle(x - 1, y - 1), 0),
            corner_of(upright_triangle(x, y - 1), 2), corner_of(turned_triangle(x, y - 1), 1)};
}

std::optional<std::uint32_t> CornerLattice::cell_beside(std::uint32_t cell, int along_u, int along_v) const
{
    return rectangle(std::int64_t{cell / tessellation_.cells_v} + along_u,
                     std::int64_t{cell % tessellation_.cells_v} + along_v);
}

std::optional<std::uint32_t> CornerLattice::rectangle(std::int64_t i, std::int64_t j) const
{
    if (i < 0 || j < 0 || i >= cells_u() || j >= tessellation_.cells_v)
        return std::nullopt;
    return static_cast<std::uint32_t>(i * tessellation_.cells_v + j);
}

std::optional<std::uint32_t> CornerLattice::upright_triangle(std::int64_t i, std::int64_t j) const
{
    if (i < 0 || j < 0 || i + j >= cells_u())
        return std::nullopt;
    const auto column = static_cast<std::uint64_t>(i);
    return static_cast<std::uint32_t>(Tessellation::cells_before_column(column, cells_u())) +
           static_cast<std::uint32_t>(2 * j);
}

/// The other half of the square whose first half is upright.
std::optional<std::uint32_t> CornerLattice::turned_triangle(std::int64_t i, std::int64_t j) const
{
    if (i < 0 || j < 0 || i + j + 1 >= cells_u())
        return std::nullopt;
    return *upright_triangle(i, j) + 1;
}

Rgb CornerLattice::interpolated(const Rgb* values, double u, double v) const
{
    const double x = u * tessellation_.cells_u;
    const double y = v * tessellation_.cells_v;
    const std::uint32_t i = cell_of(x, cells_u());
    const std::uint32_t j = cell_of(y, triangle() ? cells_u() - i : tessellation_.cells_v);
    const double right = std::clamp(x - i, 0.0, 1.0);
    const double up = std::clamp(y - j, 0.0, 1.0);
    if (!triangle()) {
        const Rgb* corner = values + per_cell * *rectangle(i, j);
        return blend(up, blend(right, corner[0], corner[1]), blend(right, corner[3], corner[2]));
    }
    const std::optional<std::uint32_t> turned = turned_triangle(i, j);
    if (right + up <= 1.0 || !turned) {
        const Rgb* corner = values + per_cell * *upright_triangle(i, j);
        return (1.0 - right - up) * corner[0] + right * corner[1] + up * corner[2];
    }
    const Rgb* corner = values + per_cell * *turned;
    return (right + up - 1.0) * corner[0] + (1.0 - right) * corner[1] + (1.0 - up) * corner[2];
}

} // namespace multipath
