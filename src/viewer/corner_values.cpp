#include "viewer/corner_values.h"

#include "image/smooth_shading.h"

#include <array>

namespace multipath {

namespace {

/// A triangle's rows get shorter.
std::size_t grid_number(const Tessellation& tessellation, GridPoint point)
{
    const std::size_t row = point.j;
    const std::size_t missing = tessellation.shape == Shape::triangle && row > 0 ? row * (row - 1) / 2 : 0;
    return row * (tessellation.cells_u + std::size_t{1}) - missing + point.i;
}

std::size_t grid_size(const Tessellation& tessellation)
{
    const std::uint32_t last = tessellation.shape == Shape::triangle ? 0 : tessellation.cells_u;
    return grid_number(tessellation, {last, tessellation.cells_v}) + 1;
}

/// Takes the patches of one side of a surface.
void append_side(const Scene& scene, std::uint32_t surface, bool front, const SmoothShading& shading,
                 CornerValues& result)
{
    const std::uint32_t first_patch = scene.first_patch(surface, front);
    const Tessellation& tessellation = scene.tessellation(surface);
    const bool source = scene.surface_material(surface).emittance != Rgb{};
    const std::size_t first = result.shared.size();
    result.shared.resize(first + grid_size(tessellation));
    std::vector<bool> known(grid_size(tessellation), false);
    for (std::uint32_t cell = 0; cell < tessellation.cell_count(); ++cell) {
        const CellCorners corners = tessellation.corners(cell);
        const std::array<Rgb, 4> values = shading.at_corners(first_patch + cell);
        for (std::uint32_t k = 0; k < corners.count; ++k) {
            const std::size_t number = grid_number(tessellation, corners.points[k]);
            if (!known[number]) {
                known[number] = true;
                result.shared[first + number] = values[k];
            } else if (!source && result.shared[first + number] != values[k]) {
                result.places.push_back(4 * (first_patch + cell) + k);
                result.own.push_back(values[k]);
            }
        }
    }
}

} // namespace

CornerValues corner_values(const Scene& scene, const std::vector<Rgb>& values_per_patch, int threads)
{
    const SmoothShading shading(scene, values_per_patch, threads);
    CornerValues result;
    const auto surfaces = static_cast<std::uint32_t>(scene.surfaces().size());
    for (std::uint32_t surface = 0; surface < surfaces; ++surface)
        append_side(scene, surface, true, shading, result);
    if (scene.two_sided())
        for (std::uint32_t surface = 0; surface < surfaces; ++surface)
            append_side(scene, surface, false, shading, result);
    return result;
}

} // namespace multipath
