#include "scene/coincident_faces.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

namespace coincident_faces_test {

using namespace multipath;

TEST_CASE("coincident faces are found, whether they look at each other or the same way")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey);            // 0: a floor
    builder.rectangle({0.6, 0, 0.6}, {0.3, 0, 0}, {0, 0, 0.3}, grey);    // 1: the bottom of a box on it, looks down
    builder.triangle({0.1, 0, 0.1}, {0.1, 0, 0.4}, {0.4, 0, 0.1}, grey); // 2: a second floor, looks up
    builder.rectangle({1, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey);            // 3: a neighbour that only touches
    builder.rectangle({0.1, 0.1, 0.1}, {0, 0, 0.1}, {0.1, 0, 0}, grey);  // 4: above
    const CoincidentPairs found = find_coincident_faces(builder.scene(1.0), 100);
    const std::vector<CoincidentFaces>& pairs = found.pairs;
    CHECK(found.complete);
    REQUIRE(pairs.size() == 2);
    CHECK((pairs[0].first == 0 && pairs[0].second == 1 && !pairs[0].same_side));
    CHECK((pairs[1].first == 0 && pairs[1].second == 2 && pairs[1].same_side));
    CHECK(find_coincident_faces(builder.scene(1.0), 1).pairs.size() == 1);
    CHECK(!find_coincident_faces(builder.scene(1.0), 1).complete);
}

} // namespace coincident_faces_test
