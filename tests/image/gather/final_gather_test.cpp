#include "image/gather/final_gather.h"

#include "image/automatic_camera.h"
#include "image/render.h"
#include "radiosity/solve.h"
#include "scene/obj/obj_reader.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>

namespace final_gather_test {

using namespace multipath;

namespace {

RenderOptions gathered(int width, int height)
{
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.shading = Shading::gather;
    options.samples_per_pixel = 4;
    options.gather_rays = 16;
    return options;
}

double mean_of(const Image& image)
{
    double sum = 0.0;
    for (const Rgb& pixel : image.pixels)
        sum += mean(pixel);
    return sum / static_cast<double>(image.pixels.size());
}

} // namespace

// B = E / (1 - rho) everywhere, from sources in full sight and from patches of one radiosity: nothing is left to
// chance.
TEST_CASE("in the furnace every gathered pixel is E / (1 - rho)")
{
    const Scene scene(read_obj("scenes/furnace.obj"), 0.5);
    const std::vector<Rgb> radiosity(scene.patch_count(), {2.0, 2.0, 2.0});
    const Image image = render(scene, radiosity, {{0.2, 0.7, 0.9}, {0.6, 0.4, 0.1}}, gathered(24, 16));
    for (const Rgb& pixel : image.pixels) {
        CHECK(pixel.r == doctest::Approx(2.0).epsilon(1e-9)); // rounding, also of Lambert's formula close to a wall
        CHECK(pixel.g == doctest::Approx(2.0).epsilon(1e-9));
        CHECK(pixel.b == doctest::Approx(2.0).epsilon(1e-9));
    }
}

// A spot of floor that reflects 0.8 below a square of 1 m^2 at distance 1 m: rho E F with F = 0.239456 (Howell B-3,
// four times a = b = 0.5). The camera looks down at it from the side.
TEST_CASE("a gathered pixel shows the closed form of the irradiance from a facing square")
{
    SceneBuilder builder;
    builder.rectangle({-1.0, 0.0, -1.0}, {0.0, 0.0, 2.0}, {2.0, 0.0, 0.0}, builder.grey(0.8, 0.0));
    builder.rectangle({-0.5, 1.0, -0.5}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.grey(0.0, 5.0));
    const Scene scene = builder.scene(2.0);
    std::vector<Rgb> radiosity(scene.patch_count());
    radiosity[scene.first_patch(1)] = {5.0, 5.0, 5.0};
    const Camera camera = {{1.5, 0.9, 0.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 1e-3};
    const Image image = render(scene, radiosity, camera, gathered(1, 1));
    CHECK(image.at(0, 0).g == doctest::Approx(0.8 * 5.0 * 0.239456).epsilon(1e-5)); // the pixel has a width
}

// Gathering moves light about within patches but neither adds nor loses any: counting the lamp twice, for example,
// would nearly double the mean.
TEST_CASE("the mean of a gathered picture is that of the plain patches")
{
    const Scene scene(read_obj("scenes/5cubes.obj"), 0.2);
    SolveOptions solving;
    solving.method = Method::reuse;
    solving.lines = 1u << 18;
    const std::vector<Rgb> radiosity = solve(scene, solving, [](double) {}).radiosity;
    const Camera camera = automatic_camera(scene, 4.0 / 3.0);
    RenderOptions options = gathered(64, 48);
    const double gathered_mean = mean_of(render(scene, radiosity, camera, options));
    options.shading = Shading::flat;
    const double flat_mean = mean_of(render(scene, radiosity, camera, options));
    // 3072 pixels of 16 rays leave 0.1 %; that patches cannot follow the light between them makes 0.3 %.
    CHECK(gathered_mean == doctest::Approx(flat_mean).epsilon(0.01));
}

// Light of the sources that has been reflected once: E + rho E, whatever the patches say.
TEST_CASE("without indirect light the furnace shows E (1 + rho)")
{
    const Scene scene(read_obj("scenes/furnace.obj"), 0.5);
    RenderOptions options = gathered(12, 8);
    options.indirect = false;
    const std::vector<Rgb> radiosity(scene.patch_count(), {2.0, 2.0, 2.0});
    for (const Rgb& pixel : render(scene, radiosity, {{0.2, 0.7, 0.9}, {0.6, 0.4, 0.1}}, options).pixels) {
        CHECK(pixel.r == doctest::Approx(1.5 * 1.25).epsilon(1e-9)); // rounding
        CHECK(pixel.b == doctest::Approx(0.5 * 1.75).epsilon(1e-9));
    }
}

} // namespace final_gather_test
