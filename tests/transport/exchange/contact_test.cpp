#include "transport/exchange/contact.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

namespace contact_test {

using namespace multipath;

TEST_CASE("a box and the floor below it are in contact, the two faces of a sheet are not")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {1, 1, 1}, wall).box({0.2, 0, 0.2}, {0.6, 0.3, 0.7}, wall); // surfaces 0 ... 5, 6 ... 11
    builder.rectangle({0.1, 0.7, 0.1}, {0.3, 0, 0}, {0, 0, 0.3}, wall);                 // 12, looks down
    builder.rectangle({0.1, 0.7, 0.1}, {0, 0, 0.3}, {0.3, 0, 0}, wall);                 // 13, looks up
    for (std::uint64_t key = 1; key <= 10; ++key) {
        const RigidMotion motion(key);
        const Scene scene(motion.moved(builder.file()), 10.0 * motion.scale(), true);
        const std::uint32_t backs = 14;
        CHECK(in_contact(scene, 0, 6));
        CHECK(in_contact(scene, 6, 0));
        CHECK(!in_contact(scene, backs + 0, backs + 6)); // below the floor and inside the box
        CHECK(!in_contact(scene, 12, 13));
        CHECK(in_contact(scene, backs + 12, backs + 13)); // inside the sheet
    }
}

TEST_CASE("slivers of an overlap are found, and patches that only share a border are not in contact")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, wall); // a floor
    builder.box({0.98, 0, 0.2}, {1.5, 0.5, 0.7}, wall);       // overhangs it: 2 cm stand on it; bottom: 1
    builder.box({-0.5, 0, 0.2}, {0.0, 0.5, 0.7}, wall);       // beside it; bottom: 7
    const Scene scene = builder.scene(10.0);
    CHECK(in_contact(scene, 0, 1));
    CHECK(!in_contact(scene, 0, 7));
}

} // namespace contact_test
