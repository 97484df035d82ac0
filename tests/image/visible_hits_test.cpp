#include "image/visible_hits.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

namespace visible_hits_test {

using namespace multipath;

// Along z the walls of a room from -2 to 2 and of a box from -1 to 1 are met at these parameters.
TEST_CASE("the first front along a ray is seen, whatever backs come before it")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    builder.room({-2, -2, -2}, {2, 2, 2}, paint).box({-1, -1, -1}, {1, 1, 1}, paint);
    const Line from_outside = {{0.1, 0.2, 5.0}, {0.0, 0.0, -1.0}};
    const Line from_inside_box = {{0.1, 0.2, 0.0}, {0.0, 0.0, -1.0}};
    const Scene scene = builder.scene(1.0);
    VisibleHits visible(scene);
    CHECK(visible.first(from_outside)->t == doctest::Approx(4.0));    // through the room's back to the box
    CHECK(visible.first(from_inside_box)->t == doctest::Approx(2.0)); // through the box's back to the room
    const Line between = {{1.5, 0.2, 0.0}, {1.0, 0.0, 0.0}};
    CHECK(visible.first(between)->t == doctest::Approx(0.5)); // no back, right after rays that passed some
    CHECK(!visible.first({{0.0, 0.0, 5.0}, {0.0, 0.0, 1.0}}));

    const Scene two_sided = builder.scene(1.0, true);
    CHECK(VisibleHits(two_sided).first(from_outside)->t == doctest::Approx(3.0));
    CHECK(!VisibleHits(two_sided).first(from_outside)->front);
}

} // namespace visible_hits_test
