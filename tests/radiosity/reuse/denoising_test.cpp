#include "radiosity/reuse/denoising.h"

#include "sampling/random.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <memory>
#include <string>

namespace denoising_test {

using namespace multipath;

namespace {

/// Standard normal numbers: the sum of twelve uniform ones, less six.
double normal(std::uint64_t key, std::uint32_t i)
{
    double sum = -6.0;
    for (std::uint32_t k = 0; k < 12; ++k)
        sum += bits_to_unit(random_bits(key, 12 * std::uint64_t{i} + k));
    return sum;
}

/// A light that is given, with noise of which every patch has its own.
struct Noisy
{
    const Scene& scene;
    std::vector<Rgb> truth;
    std::vector<Rgb> radiosity;
    std::vector<Rgb> variance;

    Noisy(const Scene& of, std::uint64_t key, const std::function<double(Vec3)>& light,
          const std::function<double(Vec3)>& deviation)
        : scene(of)
    {
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const Vec3 at = scene.patch(i).shape.centre();
            const double b = light(at);
            const double s = deviation(at);
            truth.push_back({b, b, 2.0 * b});
            radiosity.push_back(truth[i] + s * Rgb{normal(key, 3 * i), normal(key, 3 * i + 1), normal(key, 3 * i + 2)});
            variance.push_back({s * s, s * s, s * s});
        }
    }

    /// [W^2/m^2] Sum of squared errors by area.
    double error() const
    {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const Rgb d = radiosity[i] - truth[i];
            sum += scene.area(i) * (d.r * d.r + d.g * d.g + d.b * d.b);
        }
        return sum;
    }
    double predicted() const
    {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            sum += scene.area(i) * (variance[i].r + variance[i].g + variance[i].b);
        return sum;
    }
};

const auto even = [](double s) { return [s](Vec3) { return s; }; };

/// Square floors of 32 x 32 patches, of one material each.
Scene floors(int count)
{
    SceneBuilder builder;
    for (int k = 0; k < count; ++k)
        builder.rectangle({2.0 * k, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.5, k == 0 ? 0.5 : 0.0));
    return builder.scene(1.0 / 32.0);
}

/// A dome of 1,600 triangles, each a surface of its own.
Scene dome()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.1);
    const auto at = [](int i, int j) {
        const double theta = 0.02 + 1.5 * i / 20.0;
        const double phi = 6.283185307179586 * j / 40.0;
        return Vec3{std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
    };
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 40; ++j)
            builder.triangle(at(i, j), at(i, j + 1), at(i + 1, j), grey)
                .triangle(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), grey);
    return builder.scene(1.0);
}

} // namespace

TEST_CASE("smooth light loses most of its noise, on one surface and on a curved one of many triangles")
{
    const auto smooth = [](Vec3 p) { return 2.0 + 0.5 * p.x - 0.8 * p.z + 0.3 * p.x * p.z; };
    for (const bool curved : {false, true}) {
        CAPTURE(curved);
        const Scene scene = curved ? dome() : floors(1);
        double before = 0.0;
        double after = 0.0;
        double predicted = 0.0;
        for (std::uint64_t key = 1; key <= 8; ++key) {
            Noisy light(scene, key, smooth, even(0.3));
            before += light.error();
            denoise(scene, 2, light.radiosity, light.variance);
            after += light.error();
            predicted += light.predicted();
        }
        CHECK(after < before / 10.0); // 6 parameters of 1,024 patches would leave 1/170; the best of many fits, more
        CHECK(predicted > 0.4 * after);
        CHECK(predicted < 4.0 * after); // the mean over the trees has less than each of them
    }
}

// The error can be larger than the noise by what a block of a few patches hides beneath it, not more.
TEST_CASE("the border of a shadow stays where the noise is smaller than it")
{
    const auto shadow = [](Vec3 p) { return p.x + 0.3 * p.z < 0.61 ? 1.0 : 2.0; };
    const Scene scene = floors(1);
    for (const double s : {0.2, 0.02, 0.002}) {
        CAPTURE(s);
        Noisy light(scene, 5, shadow, even(s));
        const double before = light.error();
        denoise(scene, 2, light.radiosity, light.variance);
        CHECK(light.error() < 0.6 * before);
    }
}

// The reflected light on a texture of d times the mean reflectance has d times the deviation. Without the texture it is
// the light on a plain floor; so is the result. What the floor emits has no texture.
TEST_CASE("a texture does not change what is taken for noise")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.material({0.5, 0.5, 0.5}, {0.3, 0.0, 0.7}));
    builder.rectangle({0, 5, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.0, 1.0));
    SceneFile file = builder.file();
    const Scene plain(file, 1.0 / 32.0);
    std::string pixels = "P3 8 8 255\n";
    for (int k = 0; k < 64; ++k)
        pixels += std::to_string(40 + 3 * k) + " " + std::to_string(250 - 3 * k) + " " + std::to_string(90 + k) + " ";
    const auto texture = std::make_shared<const Texture>("ramp.pgm", pixels, true);
    file.textures = {texture};
    file.materials[0].texture = 0;
    file.materials[0].texture_scale = {1.0, 1.0, 1.0};
    file.materials[0].reflectance = texture->mean();
    file.texture_frames.assign(2, {{0, 0}, {1, 0}, {0, 1}, true});
    const Scene painted(file, 1.0 / 32.0);
    Noisy expected(
        plain, 8, [](Vec3 p) { return 1.0 + p.x * p.z; }, [](Vec3 p) { return p.x < 0.5 ? 0.1 : 0.3; });
    Noisy light = expected;
    std::vector<Rgb> detail;
    const auto textured = [&](std::uint32_t i, Rgb b) {
        return plain.emittance(i) + detail[i] * (b - plain.emittance(i));
    };
    for (std::uint32_t i = 0; i < painted.patch_count(); ++i) {
        const Rgb rho = painted.reflectance(i);
        const Rgb mean = texture->mean();
        detail.push_back(i < painted.first_patch(1) ? Rgb{rho.r / mean.r, rho.g / mean.g, rho.b / mean.b}
                                                    : Rgb{1, 1, 1});
        expected.radiosity[i] += plain.emittance(i);
        light.radiosity[i] = textured(i, expected.radiosity[i]);
        light.variance[i] = detail[i] * detail[i] * expected.variance[i];
    }
    denoise(plain, 2, expected.radiosity, expected.variance);
    denoise(painted, 2, light.radiosity, light.variance);
    for (std::uint32_t i = 0; i < painted.patch_count(); ++i)
        for (double Rgb::*c : {&Rgb::r, &Rgb::g, &Rgb::b}) { // but for rounding
            CHECK(light.radiosity[i].*c == doctest::Approx(textured(i, expected.radiosity[i]).*c).epsilon(1e-9));
            CHECK(light.variance[i].*c ==
                  doctest::Approx((detail[i] * detail[i] * expected.variance[i]).*c).epsilon(1e-9));
        }
}

TEST_CASE("a patch that is known to be dark stays so among noisy bright ones, and what has no variance is not touched")
{
    const Scene scene = floors(1);
    const auto niche = [](Vec3 p) { return std::abs(p.x - 0.5) < 0.02 && std::abs(p.z - 0.5) < 0.02; };
    const auto light_at = [&](Vec3 p) { return niche(p) ? 2.0 : 2.0 + p.x; }; // less than two of their deviations
    for (const double known : {0.01, 0.0}) {
        Noisy light(scene, 3, light_at, [&](Vec3 p) { return niche(p) ? known : 0.3; });
        const double before = light.error();
        denoise(scene, 2, light.radiosity, light.variance);
        CHECK(light.error() < 0.2 * before);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            if (niche(scene.patch(i).shape.centre()))
                CHECK(std::abs(light.radiosity[i].g - 2.0) < (known > 0.0 ? 0.15 : 1e-12));
    }
}

TEST_CASE("each material keeps its power, and no patch becomes darker than it emits")
{
    SceneBuilder builder;
    for (const double x : {0.0, 1.0, 2.0}) // side by side
        builder.rectangle({x, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.5, 0.5));
    for (const double patch_size : {0.25, 1.0 / 32.0}) {
        CAPTURE(patch_size);
        const Scene scene = builder.scene(patch_size);
        Noisy light(
            scene, 7, [](Vec3 p) { return 0.52 + 0.5 * std::max(0.0, p.z - 0.5 * p.x); }, even(0.3));
        for (Rgb& b : light.radiosity)
            b = {std::max(b.r, 0.5), std::max(b.g, 0.5), std::max(b.b, 0.5)};
        const std::vector<Rgb> before = light.radiosity;
        const auto power = [&](const std::vector<Rgb>& radiosity, std::uint32_t surface) {
            double sum = 0.0;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                sum += scene.surface_of(i) == surface ? scene.area(i) * radiosity[i].g : 0.0;
            return sum;
        };
        denoise(scene, 2, light.radiosity, light.variance);
        CHECK(light.radiosity != before);
        for (std::uint32_t surface = 0; surface < 3; ++surface)
            CHECK(power(light.radiosity, surface) == doctest::Approx(power(before, surface)).epsilon(1e-12));
        for (const Rgb& b : light.radiosity)
            CHECK(std::min({b.r, b.g, b.b}) >= 0.5);
    }
}

TEST_CASE("any number of threads gives the same bits, and a room of a few patches is taken as it is")
{
    const Scene scene = floors(3);
    Noisy one(
        scene, 9, [](Vec3 p) { return 1.0 + std::sin(5.0 * p.x); }, even(0.2));
    Noisy two = one;
    denoise(scene, 1, one.radiosity, one.variance);
    denoise(scene, 5, two.radiosity, two.variance);
    CHECK(one.radiosity == two.radiosity);
    CHECK(one.variance == two.variance);

    SceneBuilder builder;
    const Scene few = builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 1.0)).scene(1.0);
    Noisy single(few, 1, even(2.0), even(0.1));
    const std::vector<Rgb> before = single.radiosity;
    denoise(few, 2, single.radiosity, single.variance);
    CHECK(single.radiosity == before);
}

} // namespace denoising_test
