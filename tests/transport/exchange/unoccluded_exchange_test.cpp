#include "transport/exchange/unoccluded_exchange.h"

#include "geometry/form_factor/exchange_area.h"
#include "geometry/intersector/shared_planes.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <doctest/doctest.h>

namespace unoccluded_exchange_test {

using namespace multipath;

namespace {

double row_sum(const PairMatrix<float>& matrix, std::uint32_t i)
{
    double sum = 0.0;
    for (std::uint32_t j = 0; j < matrix.size(); ++j)
        sum += static_cast<double>(matrix.at(i, j));
    return sum;
}

/// A room with a box on its floor, a turned wall, a shelf, a skew parallelogram and a triangle: grids with two common
/// steps, with one, with opposite ones and with none.
Scene furnished_room(bool two_sided)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {3, 2, 2.5}, grey).box({0.5, 0, 0.5}, {1.5, 0.75, 1}, grey);
    builder.rectangle({2, 1, 1}, {0.4, 0, 0.3}, {0, 0.5, 0}, grey);
    builder.rectangle({2.9, 1.1, 0.2}, {-0.75, 0, 0}, {0, 0, 1}, grey);
    builder.rectangle({1, 1.5, 1}, {0.4, 0.1, 0.3}, {-0.3, 0.2, 0.4}, grey);
    builder.triangle({2, 0.2, 2}, {2.8, 0.3, 2.1}, {2.2, 1.2, 1.5}, grey);
    return builder.scene(0.25, two_sided);
}

} // namespace

// The second method is the first without what is shared between pairs.
TEST_CASE("pairs moved along a common step of two grids get what each would get by itself")
{
    for (const bool two_sided : {false, true}) {
        const Scene scene = furnished_room(two_sided);
        const PairMatrix<float> matrix = unoccluded_exchange(scene, 2);
        const double touching = coplanar_distance * scene.bounds().diagonal();
        double worst = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const FlatPiece a = scene.patch(i).shape;
            for (std::uint32_t j = 0; j < i; ++j) {
                if (scene.surface_of(i) == scene.surface_of(j)) {
                    worst = std::max(worst, static_cast<double>(matrix.at(i, j)));
                    continue;
                }
                const FlatPiece b = scene.patch(j).shape;
                const bool in_one_plane =
                    std::abs(dot(b.centre - a.centre, a.normal)) < touching && dot(a.normal, b.normal) < -0.999999;
                const double expected =
                    exchange_area(a, b, touching) * (in_one_plane ? share_in_contact(scene, i, j) : 1.0);
                const double difference = std::abs(static_cast<double>(matrix.at(i, j)) - expected);
                worst = std::max(worst, difference / std::max(expected, 1e-7 * a.area));
            }
        }
        // Rounding decides which of two rules serves a pair at the limit between them; they differ by up to 5e-4.
        CHECK(worst < 5e-4);
    }
}

TEST_CASE("the number of threads does not change a bit")
{
    const Scene scene = furnished_room(true);
    const PairMatrix<float> one = unoccluded_exchange(scene, 1);
    for (const int threads : {2, 5}) {
        const PairMatrix<float> several = unoccluded_exchange(scene, threads);
        REQUIRE(several.size() == one.size());
        CHECK(std::memcmp(one.row(0), several.row(0), sizeof(float) * one.pair_count(one.size())) == 0);
    }
}

TEST_CASE("in an empty room every patch exchanges its whole area")
{
    SceneBuilder builder;
    builder.room({-1, 0, 2}, {2, 1.7, 4.2}, builder.grey(0.5, 1.0));
    const Scene scene = builder.scene(0.25);
    const PairMatrix<float> matrix = unoccluded_exchange(scene, 2);
    double worst = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        worst = std::max(worst, std::abs(row_sum(matrix, i) / scene.area(i) - 1.0));
    CHECK(worst < 1e-5);
}

TEST_CASE("the bottom of a box exchanges its area with the floor below it")
{
    const Scene scene = furnished_room(false);
    const PairMatrix<float> matrix = unoccluded_exchange(scene, 1);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        for (std::uint32_t j = 0; j < scene.patch_count(); ++j)
            if (scene.surface_of(i) == 0 && scene.surface_of(j) == 6)
                sum += static_cast<double>(matrix.at(i, j));
    CHECK(sum == doctest::Approx(1.0 * 0.5).epsilon(1e-6));
}

// Both sides of a sheet look into a closed room, from within: each of its patches exchanges its area with the walls.
TEST_CASE("both sides of a sheet exchange with the room and not with each other")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {2, 2, 2}, grey);
    builder.triangle({0.5, 0.5, 0.5}, {1.5, 0.6, 0.7}, {0.6, 1.4, 1.5}, grey);
    const Scene scene = builder.scene(0.25, true);
    const PairMatrix<float> matrix = unoccluded_exchange(scene, 2);
    int sheets = 0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (scene.surface_of(i) == 6) {
            CHECK(row_sum(matrix, i) == doctest::Approx(scene.area(i)).epsilon(1e-5));
            ++sheets;
        }
    CHECK(sheets > 20);
}

} // namespace unoccluded_exchange_test

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
        CHECK(share_in_contact(scene, 0, 6) == 1.0);
        CHECK(share_in_contact(scene, 6, 0) == 1.0);
        CHECK(share_in_contact(scene, backs + 0, backs + 6) == 0.0); // below the floor and inside the box
        CHECK(share_in_contact(scene, 12, 13) == 0.0);
        CHECK(share_in_contact(scene, backs + 12, backs + 13) == 1.0); // inside the sheet
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
    CHECK(share_in_contact(scene, 0, 1) == 1.0);
    CHECK(share_in_contact(scene, 0, 7) == 0.0);
}

TEST_CASE("what stands between counts as an obstacle to a contact, and what does not face each other as none")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 4}, {4, 0, 0}, wall);
    builder.box({0.5, 0, 0.5}, {2.5, 0.6, 1.5}, wall); // bottom: 1
    builder.box({1.5, 0, 0.5}, {3.5, 0.4, 1.5}, wall); // bottom: 7; half of each is in the other
    builder.box({0.5, 0, 2.5}, {2.5, 0.6, 3.5}, wall); // bottom: 13
    // Begins in the box below it. Lines that meet its bottom next pass the floor and the box as a sheet (hit.cpp).
    builder.box({1.5, 0.2, 2.5}, {3.5, 0.8, 3.5}, wall);
    const Scene scene = builder.scene(10.0, true);
    CHECK(share_in_contact(scene, 0, 1) == 1.0);
    CHECK(share_in_contact(scene, 0, 7) == 1.0);
    CHECK(share_in_contact(scene, 0, 13) == doctest::Approx(0.5).epsilon(0.04));
    const PairMatrix<float> matrix = unoccluded_exchange(scene, 2);
    CHECK(static_cast<double>(matrix.at(1, 0)) == doctest::Approx(2.0));
    CHECK(static_cast<double>(matrix.at(13, 0)) == doctest::Approx(1.0).epsilon(0.04));
}

} // namespace contact_test
