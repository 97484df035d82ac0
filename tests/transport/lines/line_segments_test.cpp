#include "transport/lines/line_segments.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

namespace intersection_list_test {

using namespace multipath;

TEST_CASE("segments join departures and arrivals and name what has no patch")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey); // 0: looks up
    builder.rectangle({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, grey); // 1: looks up too, so it shows its back to 0
    builder.rectangle({0, 2, 0}, {1, 0, 0}, {0, 0, 1}, grey); // 2: looks down
    const auto segments_of = [](const Scene& scene) {
        std::vector<Hit> hits;
        std::vector<Segment> segments;
        scene.intersector().all_hits({{0.5, -1, 0.5}, {0, 1, 0}}, hits);
        append_segments(scene, hits, segments);
        return segments;
    };
    const std::vector<Segment> one_sided = segments_of(builder.scene(1.0));
    REQUIRE(one_sided.size() == 2); // those between a back and nothing are left out
    CHECK((one_sided[0].from == 0 && one_sided[0].to == Segment::behind));
    CHECK((one_sided[1].from == 1 && one_sided[1].to == 2));

    const std::vector<Segment> two_sided = segments_of(builder.scene(1.0, true)); // backs are patches 3, 4, 5
    REQUIRE(two_sided.size() == 4);
    CHECK((two_sided[0].from == Segment::outside && two_sided[0].to == 3));
    CHECK((two_sided[1].from == 0 && two_sided[1].to == 4));
    CHECK((two_sided[2].from == 1 && two_sided[2].to == 2));
    CHECK((two_sided[3].from == 5 && two_sided[3].to == Segment::outside));
}

} // namespace intersection_list_test
