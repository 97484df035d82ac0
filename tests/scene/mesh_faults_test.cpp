#include "scene/mesh_faults.h"

#include "sampling/sequence.h"
#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

namespace mesh_faults_test {

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

TEST_CASE("a closed room has no open edge, a room without one wall has four")
{
    SceneBuilder closed;
    const std::uint32_t grey = closed.grey(0.5, 1.0);
    closed.room({0, 0, 0}, {1, 2, 3}, grey).box({0.2, 0.2, 0.2}, {0.5, 0.5, 0.5}, grey);
    SurfaceList surfaces = closed.file().surfaces;
    CHECK(surfaces_with_open_edges(surfaces).empty());

    surfaces.erase(surfaces.begin()); // the floor
    CHECK(surfaces_with_open_edges(surfaces) == std::vector<std::uint32_t>{1, 2, 3, 4});
}

// Corners are computed as origin + edge, which rounds.
TEST_CASE("a turned room without one wall has four open edges, wherever it stands")
{
    std::uint64_t item = 0;
    const auto sequence = make_sequence("random", 1);
    for (int room = 0; room < 20; ++room) {
        const Item at = sequence->item(item++);
        const Item turn = sequence->item(item++);
        const double a = 6.0 * turn[0];
        const Vec3 x = {std::cos(a), 0.0, std::sin(a)};
        const Vec3 z = {-std::sin(a), 0.0, std::cos(a)};
        const auto corner = [&](int i, int j, int k) {
            return 10.0 * Vec3{at[0], at[1], at[2]} + (1.0 + turn[1]) * i * x + Vec3{0.0, (1.0 + turn[2]) * j, 0.0} +
                   (1.0 + turn[3]) * k * z;
        };
        SurfaceList surfaces;
        const auto face = [&](Vec3 p, Vec3 q, Vec3 r) { surfaces.push_back({Shape::parallelogram, p, q - p, r - p}); };
        face(corner(0, 0, 0), corner(0, 0, 1), corner(1, 0, 0));
        face(corner(0, 1, 0), corner(1, 1, 0), corner(0, 1, 1));
        face(corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0));
        face(corner(1, 0, 1), corner(0, 0, 1), corner(1, 1, 1));
        face(corner(0, 0, 1), corner(0, 0, 0), corner(0, 1, 1));
        CHECK(surfaces_with_open_edges(surfaces) == std::vector<std::uint32_t>{0, 1, 2, 3});
        face(corner(1, 0, 0), corner(1, 0, 1), corner(1, 1, 0));
        CHECK(surfaces_with_open_edges(surfaces).empty());
    }
}

TEST_CASE("triangles are closed by triangles that run along their edges the other way")
{
    const Vec3 p = {0, 0, 0}, q = {1, 0, 0}, r = {0, 1, 0}, s = {0, 0, 1};
    const auto face = [](Vec3 a, Vec3 b, Vec3 c) { return Surface{Shape::triangle, a, b - a, c - a}; };
    CHECK(surfaces_with_open_edges({face(p, r, q), face(p, q, s), face(q, r, s), face(p, s, r)}).empty());
    CHECK(surfaces_with_open_edges({face(p, r, q), face(p, q, s), face(q, r, s), face(p, r, s)}).size() == 4);
}

} // namespace mesh_faults_test
