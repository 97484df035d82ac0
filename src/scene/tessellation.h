#pragma once

#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

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
    /// The cell as a surface of its own; all cells have the same area.
    Surface cell(const Surface& surface, std::uint32_t cell) const;
};

/// Cells along an edge = ceil(edge / patch_size), at least one; a triangle is cut by its longest edge.
/// Throws InputError when a surface would get 2^31 cells or more.
Tessellation tessellate(const Surface& surface, double patch_size);

/// The patch size [scene units] that cuts the surfaces into a number of patches close to `wanted`, never above it
/// unless the surfaces alone are more.
double patch_size_for_count(const std::vector<Surface>& surfaces, std::uint64_t wanted);

} // namespace multipath
