#include "transport/patch_blocks.h"

#include <algorithm>
#include <limits>

namespace multipath {

namespace {

/// Which block of its surface a cell belongs to; below ceil(cells_u / cells) * ceil(cells_v / cells).
std::uint32_t block_in_surface(const Tessellation& grid, std::uint32_t cell, std::uint32_t cells)
{
    const Surface unit = {grid.shape, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Vec3 place = grid.cell(unit, cell).centre();
    const auto along = [&](double x, std::uint32_t count) {
        return std::min(static_cast<std::uint32_t>(x * count), count - 1) / cells;
    };
    return along(place.x, grid.cells_u) * ((grid.cells_v - 1) / cells + 1) + along(place.y, grid.cells_v);
}

std::uint32_t blocks_in_surface(const Tessellation& grid, std::uint32_t cells)
{
    return ((grid.cells_u - 1) / cells + 1) * ((grid.cells_v - 1) / cells + 1);
}

} // namespace

PatchBlocks patch_blocks(const Scene& scene, std::uint32_t cells)
{
    PatchBlocks blocks;
    blocks.block_of.reserve(scene.patch_count());
    for (int side = 0; side < (scene.two_sided() ? 2 : 1); ++side)
        for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface) {
            const Tessellation& grid = scene.tessellation(surface);
            for (std::uint32_t cell = 0; cell < grid.cell_count(); ++cell)
                blocks.block_of.push_back(blocks.count + block_in_surface(grid, cell, cells));
            blocks.count += blocks_in_surface(grid, cells);
        }
    return blocks;
}

double block_count(const Scene& scene, std::uint32_t cells)
{
    double count = 0.0;
    for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface)
        count += blocks_in_surface(scene.tessellation(surface), cells);
    return (scene.two_sided() ? 2.0 : 1.0) * count;
}

PatchBlocks surface_blocks(const Scene& scene)
{
    return patch_blocks(scene, std::numeric_limits<std::uint32_t>::max());
}

} // namespace multipath
