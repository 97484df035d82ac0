#include "transport/exchange/exchange_estimate.h"

#include "test_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <map>
#include <set>

namespace patch_blocks_test {

using namespace multipath;

namespace {

/// Rectangles of 7 x 5, 1 x 9 and 4 x 4 cells and triangles of 1, 25 and 36, so that blocks are cut off at borders.
Scene some_shapes(bool two_sided)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {7, 0, 0}, {0, 5, 0}, grey).triangle({0, 0, 1}, {3, 0, 1}, {0, 5, 1}, grey);
    builder.rectangle({0, 0, 2}, {0.5, 0, 0}, {0, 9, 0}, grey).triangle({0, 0, 3}, {0.5, 0, 3}, {0, 0.5, 3}, grey);
    builder.rectangle({0, 0, 4}, {4, 0, 0}, {0, 4, 0}, grey).triangle({0, 0, 5}, {6, 0, 5}, {0, 4, 5}, grey);
    return builder.scene(1.0, two_sided);
}

/// The square of the surface's grid that a patch lies in, told from where its centre is.
std::array<long, 2> square_of(const Scene& scene, std::uint32_t patch)
{
    const std::uint32_t surface = scene.surface_of(patch);
    const Surface& shape = scene.surfaces()[surface];
    const Vec3 d = scene.patch(patch).shape.centre() - shape.origin;
    const auto along = [&](Vec3 edge, std::uint32_t cells) {
        return std::lround(std::floor(dot(d, edge) / dot(edge, edge) * cells)); // edges at right angles
    };
    const Tessellation& grid = scene.tessellation(surface);
    return {along(shape.edge_u, grid.cells_u), along(shape.edge_v, grid.cells_v)};
}

bool on_back(const Scene& scene, std::uint32_t patch)
{
    return dot(scene.patch(patch).shape.normal(), scene.surfaces()[scene.surface_of(patch)].normal()) < 0.0;
}

std::map<std::uint32_t, std::vector<std::uint32_t>> members(const PatchBlocks& blocks)
{
    std::map<std::uint32_t, std::vector<std::uint32_t>> patches;
    for (std::uint32_t patch = 0; patch < blocks.block_of.size(); ++patch)
        patches[blocks.block_of[patch]].push_back(patch);
    return patches;
}

} // namespace

// A square of the grid of a triangle holds two patches.
TEST_CASE("a block holds neighbours on one side of one surface, and no more than its cells")
{
    for (const bool two_sided : {false, true})
        for (const std::uint32_t cells : {1u, 2u, 3u, 4u}) {
            CAPTURE(two_sided);
            CAPTURE(cells);
            const Scene scene = some_shapes(two_sided);
            const PatchBlocks blocks = patch_blocks(scene, cells);
            REQUIRE(blocks.block_of.size() == scene.patch_count());
            for (const auto& [block, patches] : members(blocks)) {
                CHECK(block < blocks.count);
                const std::uint32_t surface = scene.surface_of(patches[0]);
                const bool triangle = scene.surfaces()[surface].shape == Shape::triangle;
                CHECK(patches.size() <= (triangle ? 2 : 1) * cells * cells);
                const std::array<long, 2> first = square_of(scene, patches[0]);
                for (const std::uint32_t patch : patches) {
                    CHECK(scene.surface_of(patch) == surface);
                    CHECK(on_back(scene, patch) == on_back(scene, patches[0]));
                    const std::array<long, 2> square = square_of(scene, patch);
                    CHECK(square[0] / cells == first[0] / cells);
                    CHECK(square[1] / cells == first[1] / cells);
                }
            }
        }
}

// 7 x 5 patches in squares of 2: 4 x 3 blocks. Neighbours are not left apart: patches of one square share a block.
TEST_CASE("patches of one square of cells share a block")
{
    const Scene scene = some_shapes(true);
    for (const std::uint32_t cells : {1u, 2u, 3u, 4u}) {
        CAPTURE(cells);
        const PatchBlocks blocks = patch_blocks(scene, cells);
        std::set<std::array<long, 4>> squares;
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            const std::array<long, 2> square = square_of(scene, patch);
            squares.insert(
                {scene.surface_of(patch), on_back(scene, patch) ? 1 : 0, square[0] / cells, square[1] / cells});
        }
        CHECK(members(blocks).size() == squares.size());
    }
}

TEST_CASE("blocks of twice as many cells are made of whole blocks")
{
    for (const bool two_sided : {false, true}) {
        const Scene scene = some_shapes(two_sided);
        for (const std::uint32_t cells : {1u, 2u, 3u, 4u}) {
            CAPTURE(cells);
            const PatchBlocks fine = patch_blocks(scene, cells);
            for (const PatchBlocks& coarse : {patch_blocks(scene, 2 * cells), surface_blocks(scene)})
                for (const auto& [block, patches] : members(fine))
                    for (const std::uint32_t patch : patches)
                        CHECK(coarse.block_of[patch] == coarse.block_of[patches[0]]);
        }
    }
}

TEST_CASE("blocks and sides of surfaces are numbered in the order of their patches")
{
    for (const bool two_sided : {false, true}) {
        CAPTURE(two_sided);
        const Scene scene = some_shapes(two_sided);
        const PatchBlocks surfaces = surface_blocks(scene);
        CHECK(surfaces.count == (two_sided ? 12 : 6));
        const PatchBlocks blocks = patch_blocks(scene, 2);
        std::uint32_t highest = 0; // block on the surfaces before
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            CHECK(surfaces.block_of[patch] == scene.surface_of(patch) + (on_back(scene, patch) ? 6 : 0));
            if (patch > 0 && surfaces.block_of[patch] != surfaces.block_of[patch - 1])
                highest = *std::max_element(blocks.block_of.begin(), blocks.block_of.begin() + patch) + 1;
            CHECK(blocks.block_of[patch] >= highest);
        }
    }
}

} // namespace patch_blocks_test
