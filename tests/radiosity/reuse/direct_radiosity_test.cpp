#include "radiosity/reuse/gathered_light.h"

#include "scene/daylight.h"
#include "scene/obj/obj_reader.h"
#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

namespace direct_radiosity_test {

using namespace multipath;

// Two facing unit squares of one patch each, F = 0.199825 (see the scene file): the lamp keeps its emittance of 1,
// since what comes back to it has been reflected twice, and the target gets 0.7 F.
TEST_CASE("direct radiosity is what is emitted and what is reflected once")
{
    const Scene scene(read_obj("scenes/squares.obj"), 1.0);
    const std::vector<Rgb> direct = direct_radiosity(scene, 1);
    REQUIRE(direct.size() == 2);
    CHECK(direct[0].r == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(direct[1].r == doctest::Approx(0.7 * 0.199825).epsilon(1e-4)); // of the quadrature
    CHECK(direct_radiosity(scene, 3) == direct);
}

// In the furnace every wall gets E from the others, so that E + rho E is sent on, to be compared with E / (1 - rho).
TEST_CASE("in the furnace the direct radiosity is E (1 + rho)")
{
    const Scene scene(read_obj("scenes/furnace.obj"), 0.5);
    for (const Rgb& b : direct_radiosity(scene, 2)) {
        CHECK(b.r == doctest::Approx(1.5 * 1.25).epsilon(1e-3)); // of the quadrature, where walls meet
        CHECK(b.g == doctest::Approx(1.0 * 1.5).epsilon(1e-3));
        CHECK(b.b == doctest::Approx(0.5 * 1.75).epsilon(1e-3));
    }
}

namespace {

/// A room with a box, a panel below the ceiling and an upright lamp, whose pieces look another way and are in part
/// below the top of the box; each lamp is cut into n x n pieces.
Scene room_with_cut_lamps(int n, double emittance)
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {6, 3, 5}, paint).box({2, 0, 2}, {3.5, 1, 3}, paint);
    const std::uint32_t panel = builder.grey(0.0, emittance);
    const std::uint32_t tube = builder.grey(0.0, 3.0 * emittance);
    const double part = 1.0 / n;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            builder.rectangle({2 + 2 * i * part, 2.75, 1 + j * part}, {2 * part, 0, 0}, {0, 0, part}, panel);
            builder.rectangle({5, 0.25 + j * part, 1 + 2 * i * part}, {0, 0, 2 * part}, {0, part, 0}, tube);
        }
    return builder.scene(0.5);
}

} // namespace

// Single lamps are seen by the exact exchange area and the visible share, many by rays to a few of their clusters. The
// noise of these is 0.8 % of the light here; a cluster that is left out, or counted twice, makes more than 5 %.
TEST_CASE("lamps in pieces give the direct light of whole ones")
{
    const Scene whole = room_with_cut_lamps(1, 1.0);
    const std::vector<Rgb> expected = direct_radiosity(whole, 2);
    const std::uint32_t own = whole.first_patch(12); // the patches of the room and the box come first
    for (const int n : {3, 7}) {
        const Scene cut = room_with_cut_lamps(n, 1.0);
        const std::vector<Rgb> found = direct_radiosity(cut, 2);
        double difference = 0.0;
        double square = 0.0;
        double sum = 0.0;
        double expected_sum = 0.0;
        for (std::uint32_t i = 0; i < own; ++i) {
            const double area = cut.area(i);
            difference += area * (found[i].g - expected[i].g) * (found[i].g - expected[i].g);
            square += area * expected[i].g * expected[i].g;
            sum += area * found[i].g;
            expected_sum += area * expected[i].g;
        }
        CHECK(sum == doctest::Approx(expected_sum).epsilon(0.01));
        CHECK(std::sqrt(difference / square) < 0.02);
    }
}

// An upright lamp so far away that its pieces are taken together, with its centre below the horizon of a plate.
TEST_CASE("a far lamp that rises above the horizon by a fifth gives the same in pieces")
{
    const auto light_of_plate = [](int n) {
        SceneBuilder builder;
        builder.rectangle({0, 1, 0}, {0, 0, 0.1}, {0.1, 0, 0}, builder.grey(0.5, 0.0));
        const std::uint32_t lamp = builder.grey(0.0, 1e3);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                builder.rectangle({30, 0.2 + 1.0 * i / n, 1.0 * j / n}, {0, 0, 1.0 / n}, {0, 1.0 / n, 0}, lamp);
        return direct_radiosity(builder.scene(1.0), 1)[0].g;
    };
    const double whole = light_of_plate(1);
    CHECK(whole > 1e-4);
    CHECK(light_of_plate(10) ==
          doctest::Approx(whole).epsilon(0.1).scale(0.0)); // few rays, of which a fifth is above the horizon
}

// 2^7 is exact.
TEST_CASE("lamps 128 times as bright give 128 times the direct light, and the same where they are not")
{
    const Scene scene = room_with_cut_lamps(7, 1.0);
    const Scene bright = room_with_cut_lamps(7, 128.0);
    const std::vector<Rgb> expected = direct_radiosity(scene, 2);
    const std::vector<Rgb> found = direct_radiosity(bright, 2);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        CHECK(found[i] == 128.0 * expected[i]);
}

// Floors of two materials and of patches of many sizes see nothing but the sky, so that each receives its area times
// the light of the sky. A patch of a fifth of a ray seldom has one, which must then count for five.
TEST_CASE("floors in the open get the light of the sky from however few rays, also by the patches' own ones")
{
    SceneBuilder builder;
    const std::uint32_t materials[] = {builder.material({0.8, 0.5, 0.1}, {}), builder.grey(0.3, 0.0)};
    for (int k = 0; k < 40; ++k)
        builder.rectangle({2.5 * k, 3, 7}, {0, 0, 0.2 + 0.05 * k}, {1 + 0.03 * k, 0, 0}, materials[k % 3 / 2]);
    SceneFile file = builder.file();
    const Rgb sky = {3, 2, 1};
    add_sky(file, sky);
    const Scene scene(file, 0.4);
    const SceneLights lights(scene, 2);
    for (const std::uint32_t rays : {scene.patch_count() / 5, 3 * scene.patch_count()}) {
        CAPTURE(rays);
        const auto sequence = make_sequence("sobol-owen", 1);
        const GatheredSkylight found = gathered_skylight(scene, lights.patches.get(), *sequence, 0, rays, {2});
        Rgb by_own_rays;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            if (scene.is_sky_patch(i))
                continue;
            by_own_rays += found.by_own_rays[i];
            CHECK(found.incident[i].r == doctest::Approx(scene.area(i) * sky.r).epsilon(1e-9));
            CHECK(found.incident[i].b == doctest::Approx(scene.area(i) * sky.b).epsilon(1e-9));
        }
        const double one_ray = 1.01 / rays; // more or less, by rounding
        CHECK(by_own_rays.r == doctest::Approx(scene.own_area() * sky.r).epsilon(one_ray));
        CHECK(by_own_rays.b == doctest::Approx(scene.own_area() * sky.b).epsilon(one_ray));
    }
}

} // namespace direct_radiosity_test
