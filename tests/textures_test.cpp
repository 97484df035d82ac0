// Light on textures: a patch reflects the mean of its part, so that the light of a scene is that of its means.

#include "image/render.h"
#include "refinement/shown_error.h"
#include "seeded_runs.h"
#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>
#include <memory>

namespace textures_test {

using namespace multipath;

namespace {

/// 8 x 8 pixels of white and a dark grey by turns, of which no square of 2 x 2 differs from another.
std::shared_ptr<const Texture> checkerboard()
{
    std::string text = "P2 8 8 255\n";
    for (int k = 0; k < 64; ++k)
        text += (k + k / 8) % 2 == 0 ? "255 " : "99 ";
    return std::make_shared<const Texture>("checks.pgm", text, true);
}

/// The file with a texture on all faces, which lies on each as a whole.
SceneFile textured(SceneFile file, const std::shared_ptr<const Texture>& texture, double scale)
{
    file.textures = {texture};
    for (Material& material : file.materials) {
        material.texture = 0;
        material.texture_scale = {scale, scale, scale};
        material.reflectance = scale * texture->mean();
    }
    file.texture_frames.assign(file.surfaces.size(), {{0, 0}, {1, 0}, {0, 1}, true});
    return file;
}

SceneFile furnace(double reflectance)
{
    SceneBuilder builder;
    return builder.room({0, 0, 0}, {1, 1, 1}, builder.grey(reflectance, 1.0)).file();
}

} // namespace

TEST_CASE("in a furnace a checkerboard equals its mean")
{
    const std::shared_ptr<const Texture> checks = checkerboard();
    const Scene scene(textured(furnace(0.0), checks, 0.8), 0.25);
    const Scene mean(furnace(0.8 * checks->mean().g), 0.25);
    for (const Method method : all_methods()) {
        CAPTURE(method->name);
        const Solution with = solve(scene, random_lines(method, 1u << 14, 1), silent);
        const Solution without = solve(mean, random_lines(method, 1u << 14, 1), silent);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            CHECK(with.radiosity[i].g == doctest::Approx(without.radiosity[i].g).epsilon(1e-12));
    }
}

// Each pixel of the texture is a patch of its own here.
TEST_CASE("a textured room has the indirect light of one in mean colours" * doctest::test_suite("statistics"))
{
    const std::shared_ptr<const Texture> checks = checkerboard();
    const auto lamp_in = [](SceneFile file) {
        file.materials.push_back({"lamp", {}, {9.0, 9.0, 9.0}, "memory"});
        file.surfaces.push_back({Shape::parallelogram, {0.4, 0.99, 0.4}, {0.2, 0, 0}, {0, 0, 0.2}});
        file.material.push_back(static_cast<std::uint32_t>(file.materials.size() - 1));
        file.group.push_back(0);
        file.line.push_back(0);
        if (!file.textures.empty())
            file.texture_frames.emplace_back();
        for (Material& material : file.materials)
            material.emittance = material.name == "lamp" ? material.emittance : Rgb{};
        return file;
    };
    const Scene scene(lamp_in(textured(furnace(0.0), checks, 0.8)), 0.125);
    const Scene mean(lamp_in(furnace(0.8 * checks->mean().g)), 0.125);
    const auto light_on_floor = [](const Scene& room) {
        return over_seeds(room, random_lines(Method::reuse, 1u << 14, 0), 20, [&room](const Solution& s) {
            double light = 0.0;
            for (std::uint32_t i = 0; room.surface_of(i) == 0; ++i)
                light += room.area(i) * s.radiosity[i].g / room.reflectance(i).g;
            return light;
        });
    };
    const Estimate with = light_on_floor(scene);
    const Estimate without = light_on_floor(mean);
    CHECK(std::abs(with.mean - without.mean) < 4.0 * (with.standard_error + without.standard_error) + 1e-3 * with.mean);
}

TEST_CASE("a picture shows the texture at full resolution on smooth light")
{
    const std::shared_ptr<const Texture> checks = checkerboard();
    const Scene scene(textured(furnace(0.0), checks, 0.8), 0.5); // patches of 4 x 4 pixels of the texture
    const std::vector<Rgb> radiosity(scene.patch_count(), Rgb{2.0, 2.0, 2.0});
    RenderOptions options;
    options.width = options.height = 256;
    options.samples_per_pixel = 1;
    options.shading = Shading::smooth;
    Camera camera;
    camera.eye = {0.5, 0.5, 0.5};
    camera.target = {0.5, 0.5, 1.0};
    camera.up = {0, 1, 0};
    camera.field_of_view = 60;
    const Image image = render(scene, radiosity, camera, options);
    double least = 1e9;
    double most = 0.0;
    double sum = 0.0;
    for (const Rgb& pixel : image.pixels) {
        least = std::min(least, pixel.g);
        most = std::max(most, pixel.g);
        sum += pixel.g;
    }
    // B = E + rho H with H from the mean: 1 of the 2 is reflected.
    const double light = 1.0 / checks->mean().g;
    CHECK(most == doctest::Approx(1.0 + light).epsilon(0.02));
    CHECK(least == doctest::Approx(1.0 + light * linear_colour(checks->bitmap().row(0) + 3).g).epsilon(0.02));
    CHECK(sum / static_cast<double>(image.pixels.size()) == doctest::Approx(2.0).epsilon(0.05));
    options.shading = Shading::flat;
    for (const Rgb& pixel : render(scene, radiosity, camera, options).pixels)
        CHECK(pixel.g == 2.0);
}

// Patches of 4 x 4 pixels in even light: the texture itself is no error, since pictures show it.
TEST_CASE("a texture does not add to the error of the patches")
{
    const Scene scene(textured(furnace(0.0), checkerboard(), 0.8), 0.5);
    CHECK(patch_error(scene, 0.0, 2e9, 2, silent).root_upper_bound() < 0.01);
}

} // namespace textures_test
