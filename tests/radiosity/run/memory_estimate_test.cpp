#include "radiosity/run/memory_estimate.h"

#include "radiosity/reuse/line_reuse.h"
#include "radiosity/run/solve.h"
#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

namespace memory_estimate_test {

using namespace multipath;

TEST_CASE("pairs get what scene and light leave of the memory, and the table is made where it fits")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, wall).scene(0.25);
    const double others = run_bytes(static_cast<double>(scene.surfaces().size()), scene.patch_count());
    const double table = reuse_bytes(scene);
    CHECK(bytes_for_pairs(others + 12345.0, scene) == 12345.0);
    CHECK(bytes_for_pairs(0.5 * others, scene) == 0.0);

    SolveOptions options;
    options.method = Method::reuse;
    options.memory = others + table;
    CHECK(prepare(scene, options).unoccluded.valid());
    options.memory -= 1.0;
    CHECK_FALSE(prepare(scene, options).unoccluded.valid());
}

// Pairs of patches on one wall take 20 bytes each; a patch that is a surface is also a block of each of the larger
// sizes.
TEST_CASE("a table of pairs is made for at most nine pairs per line, or fewer where patches are surfaces of their own")
{
    SceneBuilder few, many;
    const std::uint32_t lamp = few.grey(0.5, 1.0);
    many.grey(0.5, 1.0);
    few.rectangle({0, 0, 0}, {0, 0, 8}, {8, 0, 0}, lamp);
    for (int k = 0; k < 64; ++k)
        many.rectangle({k % 8 * 1.0, 0, k / 8 * 1.0}, {0, 0, 1}, {1, 0, 0}, lamp);
    const double pairs = 64 * 65 / 2;
    for (const auto& [builder, bytes] : {std::pair{&few, 20 * pairs}, {&many, (12 + 4 * 24) * pairs}}) {
        const Scene scene = builder->scene(1.0);
        REQUIRE(scene.patch_count() == 64);
        SolveOptions options;
        options.method = Method::reuse;
        options.lines = static_cast<std::uint64_t>(std::ceil(bytes / 180));
        CHECK(prepare(scene, options).unoccluded.valid());
        options.lines -= 1;
        CHECK_FALSE(prepare(scene, options).unoccluded.valid());
    }
}

TEST_CASE("the table's bytes count the pairs of surfaces where those are as many as patches")
{
    SceneBuilder few, many;
    const std::uint32_t wall = few.grey(0.5, 1.0);
    many.grey(0.5, 1.0);
    few.rectangle({0, 0, 0}, {0, 0, 10}, {10, 0, 0}, wall);
    for (int k = 0; k < 100; ++k)
        many.rectangle({k % 10 * 1.0, 0, k / 10 * 1.0}, {0, 0, 1}, {1, 0, 0}, wall);
    const Scene one = few.scene(1.0);
    const Scene tiles = many.scene(1.0);
    REQUIRE(one.patch_count() == tiles.patch_count());
    CHECK(reuse_bytes(one) == 20.0 * 100 * 101 / 2);
    CHECK(reuse_bytes(tiles) == (12.0 + 4 * 24.0) * 100 * 101 / 2);
}

// All pairs of 200 sheets lie along a line. Lines rarely meet 100 faces on each other in a large room.
TEST_CASE("no table is made where lines cross very many surfaces, or faces lie on each other")
{
    SolveOptions options;
    options.method = Method::reuse;
    SceneBuilder stack, pile;
    const std::uint32_t grey = stack.grey(0.5, 1.0);
    for (int k = 0; k < 200; ++k)
        stack.rectangle({0, 1e-4 * k, 0}, {0, 0, 1}, {1, 0, 0}, grey);
    CHECK_FALSE(prepare(stack.scene(1.0), options).unoccluded.valid());

    pile.room({0, 0, 0}, {9, 9, 9}, pile.grey(0.5, 1.0));
    CHECK(prepare(pile.scene(1.0), options).unoccluded.valid());
    for (int k = 0; k < 100; ++k)
        pile.rectangle({4, 4, 4}, {0, 0, k % 2 == 0 ? 1.0 : 0.5}, {k % 2 == 0 ? 0.5 : 1.0, 0, 0}, 0);
    CHECK_FALSE(prepare(pile.scene(9.0), options).unoccluded.valid());
}

} // namespace memory_estimate_test
