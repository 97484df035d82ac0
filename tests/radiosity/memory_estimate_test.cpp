#include "radiosity/memory_estimate.h"

#include "radiosity/line_reuse.h"
#include "radiosity/solve.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

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
    CHECK((prepare(scene, options).unoccluded != nullptr));
    options.memory -= 1.0;
    CHECK((prepare(scene, options).unoccluded == nullptr));
}
