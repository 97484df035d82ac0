#include "explain/words.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

namespace words_test {

using namespace multipath;

TEST_CASE("a surface without a name has its material's, and a back is called one")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.7, 1.0));
    const Scene scene = builder.scene(1.0, true);
    CHECK(surface_name(scene, 0) == "material0 (line 1)");
    CHECK(patch_name(scene, 0) == "patch 0 of material0 (line 1)");
    CHECK(patch_name(scene, 1) == "patch 1 of material0 (line 1), its back");
}

} // namespace words_test
