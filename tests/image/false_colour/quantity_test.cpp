#include "image/false_colour/quantity.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace quantity_test {

using namespace multipath;

// B = E + rho H, for an H that is made up. A rounding of B is a share of 1e-16 of E + rho H, so of H at most
// 1e-16 (1 + E / (rho H)) = 1e-16 (1 + 100 / 0.1) here.
TEST_CASE("the irradiance is the one that the radiosity comes from")
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {1, 1, 1}, builder.material({0.5, 0.2, 0.9}, {0, 0, 0}));
    builder.rectangle({0.2, 0.9, 0.2}, {0.5, 0, 0}, {0, 0, 0.5}, builder.material({0.1, 0.3, 0.8}, {100, 10, 1}));
    const Scene scene = builder.scene(0.3);
    std::vector<Rgb> expected;
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        expected.push_back({1.0 + i, 2.0 + 0.5 * i, 3.0 / (1.0 + i)});
        radiosity.push_back(scene.emittance(i) + scene.reflectance(i) * expected[i]);
    }
    const std::vector<Rgb> found = irradiance(scene, radiosity);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i].r == doctest::Approx(expected[i].r).epsilon(1e-12));
        CHECK(found[i].g == doctest::Approx(expected[i].g).epsilon(1e-12));
        CHECK(found[i].b == doctest::Approx(expected[i].b).epsilon(1e-12));
    }
}

TEST_CASE("what reflects nothing does not tell its irradiance")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.material({0.0, 0.5, 0.0}, {2, 2, 2}));
    const Scene scene = builder.scene(1.0);
    const Rgb found = irradiance(scene, {{2.0, 3.0, 2.0}}).front();
    CHECK(std::isnan(found.r));
    CHECK(found.g == 2.0);
    CHECK(std::isnan(found.b));
}

TEST_CASE("an emittance rounded up is no light missing")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.5, 2.0));
    const double below = std::nextafter(2.0, 0.0);
    CHECK(irradiance(builder.scene(1.0), {{below, below, below}}).front() == Rgb{});
}

// Alike: less than a step of 1/32 in every channel. One pair in fifty may be.
TEST_CASE("a screen can show the colours of the patches, and nearly all differ from the next")
{
    const std::vector<Rgb> colours = patch_colours(4000);
    int alike = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        CHECK(std::min({colours[i].r, colours[i].g, colours[i].b}) >= 0.0);
        CHECK(std::max({colours[i].r, colours[i].g, colours[i].b}) <= 1.0);
        if (i == 0)
            continue;
        const Rgb d = colours[i] - colours[i - 1];
        alike += std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)}) < 1.0 / 32;
    }
    CHECK(alike < 4000 / 50);
}

TEST_CASE("the colours of normals are those of the axes, opposite ones complementary")
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {1, 1, 1}, builder.grey(0.5, 1.0));
    const std::vector<Rgb> colours = normal_colours(builder.scene(1.0)); // in the order of room()
    REQUIRE(colours.size() == 6);
    CHECK(colours[0] == Rgb{0.5, 1.0, 0.5}); // the floor looks along y
    CHECK(colours[1] == Rgb{0.5, 0.0, 0.5});
    CHECK(colours[2] == Rgb{1.0, 0.5, 0.5});
    CHECK(colours[5] == Rgb{0.5, 0.5, 0.0});
}

TEST_CASE("magnitudes have no sign")
{
    CHECK(magnitudes({{-1.0, 2.0, -0.0}}) == std::vector<Rgb>{{1.0, 2.0, 0.0}});
}

} // namespace quantity_test
