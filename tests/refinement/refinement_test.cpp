#include "refinement/shown_error.h"

#include "base/elementary.h"
#include "image/shading/smooth_shading.h"
#include "irradiance_past.h"
#include "radiosity/run/replicates.h"
#include "radiosity/run/solve.h"
#include "refinement/adaptive_patches.h"
#include "refinement/patch_tolerance.h"
#include "scene/tessellation.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace refinement_test {

using namespace multipath;

namespace {

Rgb grey(double value)
{
    return {value, value, value};
}

/// A rectangle parallel to a floor, x and z from low to high.
struct Level
{
    std::array<double, 2> x;
    std::array<double, 2> z;
    double height;
};

constexpr Level lamp = {{-0.5, 0.5}, {-0.35, 0.35}, 2.5};
constexpr Level blocker = {{-0.6, 0.15}, {-0.5, 0.4}, 1.1};

/// A floor of 4 x 4 m that reflects half, under a lamp of 10 W/m^2 and a black sheet between them.
Scene penumbra(double patch_size)
{
    SceneBuilder builder;
    builder.rectangle({-2.0, 0.0, -2.0}, {0.0, 0.0, 4.0}, {4.0, 0.0, 0.0}, builder.grey(0.5, 0.0));
    const auto sheet = [&](const Level& at, bool up, std::uint32_t paint) {
        const Vec3 corner = {at.x[0], at.height, at.z[0]};
        const Vec3 along_x = {at.x[1] - at.x[0], 0.0, 0.0};
        const Vec3 along_z = {0.0, 0.0, at.z[1] - at.z[0]};
        builder.rectangle(corner, up ? along_z : along_x, up ? along_x : along_z, paint);
    };
    sheet(lamp, false, builder.grey(0.0, 10.0));
    const std::uint32_t black = builder.grey(0.0, 0.0);
    sheet(blocker, true, black);
    sheet(blocker, false, black);
    return builder.scene(patch_size);
}

/// Configuration factor from a point of a floor to a rectangle parallel to it with a corner above the point (Howell,
/// B-1), for signed edges.
double corner_factor(double a, double b)
{
    const double sign = (a < 0.0) == (b < 0.0) ? 1.0 : -1.0;
    a = std::abs(a);
    b = std::abs(b);
    const double p = std::hypot(1.0, a);
    const double q = std::hypot(1.0, b);
    return sign * (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2.0 * pi);
}

double factor(double x, double z, std::array<double, 2> x_range, std::array<double, 2> z_range)
{
    if (!(x_range[0] < x_range[1] && z_range[0] < z_range[1]))
        return 0.0;
    const auto at = [&](int i, int j) {
        return corner_factor((x_range[static_cast<std::size_t>(i)] - x) / lamp.height,
                             (z_range[static_cast<std::size_t>(j)] - z) / lamp.height);
    };
    return at(1, 1) - at(0, 1) - at(1, 0) + at(0, 0);
}

/// [W/m^2] Radiosity of the floor: what the shadow of the blocker on the plane of the lamp leaves of it, by Lambert.
double exact_floor(double x, double z)
{
    const double k = lamp.height / blocker.height;
    const auto hidden = [&](double from, std::array<double, 2> by, std::array<double, 2> of) {
        return std::array<double, 2>{std::max(of[0], from + k * (by[0] - from)),
                                     std::min(of[1], from + k * (by[1] - from))};
    };
    return 0.5 * 10.0 *
           (factor(x, z, lamp.x, lamp.z) - factor(x, z, hidden(x, blocker.x, lamp.x), hidden(z, blocker.z, lamp.z)));
}

TruthAtPoint exact(const Scene& scene, const Hit& hit)
{
    const Vec3 point = scene.surfaces()[hit.surface].at(hit.u, hit.v);
    const Rgb value =
        hit.surface == 0 ? grey(exact_floor(point.x, point.z)) : scene.surface_material(hit.surface).emittance;
    return {value, value};
}

ShownError exact_error(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    const Truth truth = [&](const Hit& hit, std::uint64_t) { return exact(scene, hit); };
    return shown_error(scene, radiosity, radiosity, truth, 16384, 2);
}

double error_of(const Scene& scene, std::uint64_t lines)
{
    SolveOptions options;
    options.method = Method::reuse;
    options.lines = lines;
    return exact_error(scene, solve(scene, options, [](double) {}).radiosity).relative_mean_square;
}

/// One of 400 places spread over the floor.
Hit floor_point(std::uint64_t k)
{
    return {0.0, 0, (static_cast<double>(k % 20) + 0.5) / 20.0, (static_cast<double>(k) + 0.5) / 400.0, true};
}

/// From a solution of the scene itself.
Truth gathered(const Scene& scene, std::uint64_t lines, int rays)
{
    SolveOptions options;
    options.lines = lines;
    return gathered_truth(scene, solve(scene, options, [](double) {}).radiosity, rays, 1);
}

} // namespace

// 3 shown instead of 2: (3 - 2)^2 / 2^2. Noise of +-1 in both estimates, independent, leaves the mean.
TEST_CASE("the error is that of what is shown, and noise of the truth does not add to it")
{
    SceneBuilder builder;
    builder.rectangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
    builder.rectangle({5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 3.0));
    const Scene scene = builder.scene(0.4);
    const std::vector<Rgb> shown(scene.patch_count(), grey(3.0));
    const std::vector<Rgb> guide(scene.patch_count()); // nothing reflects: points by area and patches alone
    const auto noisy = [](double noise) {
        return [noise](const Hit&, std::uint64_t number) {
            return TruthAtPoint{grey(2.0 + (number % 2 == 0 ? noise : -noise)),
                                grey(2.0 + (number % 4 < 2 ? noise : -noise))};
        };
    };
    const ShownError sharp = shown_error(scene, shown, guide, noisy(0.0), 4096, 1);
    CHECK(sharp.points == 4096);
    CHECK(sharp.area == doctest::Approx(2.0));
    CHECK(sharp.relative_mean_square == doctest::Approx(0.25).epsilon(1e-12)); // rounding
    CHECK(sharp.standard_error < 1e-8);
    const ShownError noise = shown_error(scene, shown, guide, noisy(1.0), 4096, 1);
    CHECK(noise.relative_mean_square == doctest::Approx(0.25).epsilon(0.1));
    CHECK(std::abs(noise.relative_mean_square - 0.25) < 4.0 * noise.standard_error);
    CHECK(noise.standard_error > 0.0);
}

// A strip cut in two, of which one half is cut much finer: points are drawn from its many small patches more often, and
// count less. On that half alone 3 is shown instead of 2.
TEST_CASE("small patches do not count more than their area")
{
    SceneBuilder builder;
    builder.rectangle({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
    builder.rectangle({5.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}, builder.grey(0.5, 3.0));
    const Scene coarse = builder.scene(1.0);
    REQUIRE(coarse.patch_count() == 3);
    std::vector<std::uint8_t> levels(64, 3);
    levels.insert(levels.end(), {0, 0});
    const Scene scene = coarse.refined(levels);
    const std::vector<Rgb> shown(scene.patch_count(), grey(3.0));
    const auto truth = [](const Hit& hit, std::uint64_t) {
        const Rgb value = grey(hit.surface == 0 && hit.u < 0.5 ? 2.0 : 3.0);
        return TruthAtPoint{value, value};
    };
    const ShownError error = shown_error(scene, shown, shown, truth, 16384, 1);
    const double mean_true = (1.0 * 2.0 + 1.01 * 3.0) / 2.01;
    const double expected = 1.0 / 2.01 / (mean_true * mean_true);
    CHECK(error.area == doctest::Approx(2.01).epsilon(1e-3));
    CHECK(error.mean_true == doctest::Approx(mean_true).epsilon(1e-3));
    CHECK(error.relative_mean_square == doctest::Approx(expected).epsilon(0.01));
}

// 3 is shown instead of 2 on the half that has most points, and instead of 3.5 on the other.
TEST_CASE("bright patches do not count more than their area")
{
    SceneBuilder builder;
    builder.rectangle({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
    builder.rectangle({5.0, 0.0, 0.0}, {0.01, 0.0, 0.0}, {0.0, 0.01, 0.0}, builder.grey(0.5, 2.0));
    const Scene scene = builder.scene(0.25);
    std::vector<Rgb> guide(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        guide[i] = grey(scene.patch(i).shape.centre().x < 1.0 ? 10.0 : 0.1);
    const std::vector<Rgb> shown(scene.patch_count(), grey(3.0));
    const auto truth = [](const Hit& hit, std::uint64_t) {
        const Rgb value = grey(hit.surface == 0 && hit.u < 0.5 ? 2.0 : 3.5);
        return TruthAtPoint{value, value};
    };
    const ShownError error = shown_error(scene, shown, guide, truth, 16384, 1);
    CHECK(error.area == doctest::Approx(2.0).epsilon(2e-3));
    CHECK(error.mean_true == doctest::Approx(2.75).epsilon(2e-3));
    CHECK(error.relative_mean_square == doctest::Approx((0.5 + 0.125) / (2.75 * 2.75)).epsilon(0.01));
}

// A large and a small sheet whose backs count as well; 3 is shown instead of 2 on one of the four sides.
TEST_CASE("each side of each surface counts by its area")
{
    SceneBuilder builder;
    builder.rectangle({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
    builder.rectangle({5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 3.0));
    const Scene scene = builder.scene(0.5, true);
    const std::vector<Rgb> shown(scene.patch_count(), grey(3.0));
    const std::vector<Rgb> guide(scene.patch_count()); // nothing reflects: points by area and patches alone
    for (const std::uint32_t surface : {0u, 1u})
        for (const bool front : {true, false}) {
            CAPTURE(surface);
            CAPTURE(front);
            const auto truth = [&](const Hit& hit, std::uint64_t) {
                const Rgb value = grey(hit.surface == surface && hit.front == front ? 2.0 : 3.0);
                return TruthAtPoint{value, value};
            };
            const ShownError error = shown_error(scene, shown, guide, truth, 16384, 1);
            const double share = (surface == 0 ? 2.0 : 1.0) / 6.0;
            const double mean_true = 3.0 - share;
            CHECK(error.mean_true == doctest::Approx(mean_true).epsilon(1e-3)); // a low-discrepancy sequence
            CHECK(error.relative_mean_square == doctest::Approx(share / (mean_true * mean_true)).epsilon(0.01));
        }
}

// A box on a floor covers a quarter of it, and the floor covers the bottom of the box.
TEST_CASE("the area of the error is that of what is not covered")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {2, 0, 0}, builder.grey(0.5, 1.0));
    builder.box({0.5, 0, 0.5}, {1.5, 1, 1.5}, builder.grey(0.5, 0.0));
    const Scene scene = builder.scene(0.5);
    const std::vector<Rgb> shown(scene.patch_count(), grey(3.0));
    const auto truth = [](const Hit&, std::uint64_t) { return TruthAtPoint{grey(2.0), grey(2.0)}; };
    const ShownError error = shown_error(scene, shown, shown, truth, 16384, 1);
    CHECK(error.points < 16384);
    CHECK(error.area == doctest::Approx(4.0 + 6.0 - 2.0).epsilon(5e-3)); // a low-discrepancy sequence
}

// With few rays, so that both estimates are noisy: the product of their deviations has the mean 0.
TEST_CASE("the two estimates of a point are independent, and so are those of different points")
{
    const Scene scene = penumbra(0.5);
    const Truth truth = gathered(scene, 1u << 14, 4);
    constexpr std::uint64_t points = 20000;
    double one = 0.0;
    double square = 0.0;
    double product = 0.0;
    for (std::uint64_t k = 0; k < points; ++k) {
        const Hit hit = {0.0, 0, 0.5, 0.5 + 0.12 * (static_cast<double>(k) + 0.5) / points, true}; // half hidden
        const TruthAtPoint found = truth(hit, k);
        const Rgb expected = exact(scene, hit).one;
        const double first = mean(found.one - expected);
        const double second = mean(found.other - expected);
        one += first;
        square += 0.5 * (first * first + second * second);
        product += first * second;
    }
    const double variance = square / points;
    CHECK(variance > 1e-4);
    CHECK(std::abs(one / points) < 4.0 * std::sqrt(variance / points));
    CHECK(std::abs(product / points) < 4.0 * variance / std::sqrt(points));
}

TEST_CASE("gathered truth is the exact solution")
{
    const Scene scene = penumbra(0.1);
    const Truth truth = gathered(scene, 1u << 16, 256);
    double difference = 0.0;
    double light = 0.0;
    for (std::uint64_t k = 0; k < 400; ++k) {
        const Hit hit = floor_point(k);
        const TruthAtPoint found = truth(hit, k);
        const Rgb expected = exact(scene, hit).one;
        difference += mean((found.one - expected) * (found.one - expected));
        light += mean(expected * expected);
    }
    CHECK(difference < 1e-4 * light); // noise of 256 rays to the lamp
}

// Two sheets that are not parallel to the floor, one of them a triangle.
TEST_CASE("gathered truth is the exact light past tilted sheets")
{
    const Surface source = {Shape::parallelogram, {0, 1, 0}, {1, 0, 0}, {0, 0, 0.8}};
    const std::vector<Surface> sheets = {{Shape::parallelogram, {0.3, 0.55, 0.2}, {0.4, 0.2, 0.1}, {-0.1, 0.1, 0.5}},
                                         {Shape::triangle, {0.1, 0.4, 0.1}, {0.3, 0.1, 0.0}, {0.0, 0.1, 0.5}}};
    SceneBuilder builder;
    const std::uint32_t black = builder.grey(0.0, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.5, 0.0)).surface(source, builder.grey(0.0, 1.0));
    for (Surface sheet : sheets) {
        builder.surface(sheet, black);
        std::swap(sheet.edge_u, sheet.edge_v);
        builder.surface(sheet, black);
    }
    const Scene scene = builder.scene(0.1);
    const Truth truth = gathered(scene, 1u << 16, 1024);
    double difference = 0.0;
    double light = 0.0;
    for (std::uint64_t k = 0; k < 400; ++k) {
        const Hit hit = floor_point(k);
        const TruthAtPoint found = truth(hit, k);
        const Vec3 point = scene.surfaces()[0].at(hit.u, hit.v);
        const double expected = 0.5 * irradiance_past(sheets, source, point, {0, 1, 0});
        difference += std::pow(mean(found.one) - expected, 2);
        light += expected * expected;
    }
    CHECK(difference < 1e-4 * light); // noise of 1024 rays to the lamp
}

TEST_CASE("the shadow of a level sheet is that of the general formula")
{
    const auto surface = [](const Level& at) {
        return Surface{Shape::parallelogram,
                       {at.x[0], at.height, at.z[0]},
                       {at.x[1] - at.x[0], 0.0, 0.0},
                       {0.0, 0.0, at.z[1] - at.z[0]}};
    };
    for (int k = 0; k < 100; ++k) {
        const double x = -1.9 + 0.4 * (k % 10);
        const double z = -1.9 + 0.4 * (k / 10);
        const double factor = irradiance_past({surface(blocker)}, surface(lamp), {x, 0.0, z}, {0, 1, 0});
        CHECK(0.5 * 10.0 * factor == doctest::Approx(exact_floor(x, z)).epsilon(1e-10));
    }
}

// A quarter of the error per patch would be first order in the number of patches; 4^1.5 = 8 is asked for.
TEST_CASE("with adaptive patches the error falls faster than n^-1.5, and below that of equal ones")
{
    const auto adaptive = [](std::uint64_t patches) {
        return adaptively_refined(penumbra(std::sqrt(3.0 * 16.0 / static_cast<double>(patches))), patches, 2e9, 2,
                                  [](double) {});
    };
    const Scene few = adaptive(250);
    const Scene many = adaptive(1000);
    REQUIRE(few.patch_count() <= 250);
    REQUIRE(many.patch_count() <= 1000);
    REQUIRE(many.patch_count() > 990);
    const double error = error_of(many, 1u << 20);
    CHECK(error < error_of(few, 1u << 20) / 8.0);
    const Scene equal = penumbra(std::sqrt(16.0 / 1000.0));
    REQUIRE(equal.patch_count() > 1000);
    CHECK(error < 0.6 * error_of(equal, 1u << 20)); // 0.50 measured
}

// What solve chooses without options: a third of 5,000 patches to begin with, and 2^20 lines.
TEST_CASE("the default shows the penumbra with an error below 2e-5")
{
    const Scene coarse = penumbra(patch_size_for_count(penumbra(10.0).surfaces(), 5000 / 3));
    const Scene scene = adaptively_refined(coarse, 5000, 2e9, 2, [](double) {});
    SolveOptions options;
    options.method = Method::reuse;
    options.threads = 2;
    const Solution solution = solve(scene, options, [](double) {});
    const SmoothShading shading(scene, solution.radiosity, 2);
    double square = 0.0;
    double mean_true = 0.0;
    constexpr int along = 400;
    for (int k = 0; k < along * along; ++k) {
        const Hit hit = {0.0, 0, (k % along + 0.5) / along, (k / along + 0.5) / along, true};
        const Rgb expected = exact(scene, hit).one;
        square += mean((shading.at(hit) - expected) * (shading.at(hit) - expected)) / (along * along);
        mean_true += mean(expected) / (along * along);
    }
    CHECK(square < 2e-5 * mean_true * mean_true);
}

// Where the lamp is seen in part.
TEST_CASE("the smallest patches lie in the penumbra, and are the same for any number of threads")
{
    const Scene coarse = penumbra(0.25);
    const Scene scene = adaptively_refined(coarse, 1200, 2e9, 2, [](double) {});
    CHECK(adaptively_refined(coarse, 1200, 2e9, 1, [](double) {}).hash() == scene.hash());
    const std::vector<std::uint8_t> levels = scene.levels();
    const std::uint8_t highest = *std::max_element(levels.begin(), levels.end());
    REQUIRE(highest >= 2);
    int smallest = 0;
    int in_penumbra = 0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        if (levels[i] < highest)
            continue;
        const Vec3 centre = scene.patch(i).shape.centre();
        const double all = 5.0 * factor(centre.x, centre.z, lamp.x, lamp.z);
        const double share = exact_floor(centre.x, centre.z) / all;
        ++smallest;
        in_penumbra += share > 0.0 && share < 1.0 ? 1 : 0;
    }
    CHECK(in_penumbra > 0.8 * smallest);
}

TEST_CASE("where the radiosity is the same everywhere no patch is cut")
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {1, 2, 3}, builder.grey(0.5, 1.0));
    const Scene coarse = builder.scene(0.3);
    CHECK(adaptively_refined(coarse, 4 * coarse.patch_count(), 2e9, 1, [](double) {}).patch_count() ==
          coarse.patch_count());
}

// With 2^22 lines next to nothing but the patches is left of the error.
TEST_CASE("the patches' error is found from few lines")
{
    const Scene scene = penumbra(0.1);
    const ShownError patches = patch_error(scene, 0.0, 2e9, 2, [](double) {});
    const double expected = error_of(scene, 1u << 22);
    CHECK(patches.relative_mean_square == doctest::Approx(expected).epsilon(0.2));
    CHECK(patches.root_upper_bound() > patches.root());
    CHECK(patch_error(scene, 0.0, 2e9, 1, [](double) {}).relative_mean_square == patches.relative_mean_square);
}

TEST_CASE("patches are chosen until they suffice, or a callback has enough of them")
{
    const Scene coarse = penumbra(0.4);
    const double first = patch_error(coarse, 0.0, 2e9, 2, [](double) {}).root_upper_bound();
    const double wanted = 0.1 * first;
    std::vector<double> cuts;
    const auto before_cut = [&](double patches) { cuts.push_back(patches); };
    const RefinedScene whole = refined_to_error(coarse, wanted, before_cut, 2e9, 2, [](double) {});
    CHECK(whole.error <= wanted);
    CHECK(whole.error == patch_error(whole.scene, wanted, 2e9, 1, [](double) {}).root_upper_bound());
    REQUIRE(cuts.size() >= 2);
    CHECK(std::is_sorted(cuts.begin(), cuts.end()));
    CHECK(whole.scene.patch_count() <= cuts.back());
    const std::size_t all = cuts.size();
    const auto enough_at = [&](std::size_t cut, double share) {
        cuts.clear();
        const auto progress = [&](double done) {
            if (cuts.size() == cut && done >= share)
                throw EnoughPatches{};
        };
        return refined_to_error(coarse, wanted, before_cut, 2e9, 2, progress);
    };
    for (const double share : {0.0, 0.7}) {
        const RefinedScene none = enough_at(1, share);
        CHECK(none.scene.patch_count() == coarse.patch_count());
        CHECK(none.error == patch_error(coarse, wanted, 2e9, 2, [](double) {}).root_upper_bound());
        const RefinedScene some = enough_at(all, share);
        CHECK(some.scene.patch_count() > coarse.patch_count());
        CHECK(some.scene.patch_count() < whole.scene.patch_count());
        CHECK(some.error > wanted);
    }
}

// 54 of 60 are nine of ten.
TEST_CASE("what is told of the total error is more than the truth in nine of ten runs" *
          doctest::test_suite("statistics"))
{
    int covered = 0;
    int runs = 0;
    for (const double size : {0.4, 0.2, 0.1}) {
        const Scene scene = penumbra(size);
        const double patches = patch_error(scene, 0.0, 2e9, 2, [](double) {}).root_upper_bound();
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            SolveOptions options;
            options.method = seed % 2 == 0 ? Method::reuse : Method::first_shot;
            options.lines = std::uint64_t{1} << (14 + seed % 5);
            options.seed = seed;
            const Solution found = solve_replicates(scene, prepare(scene, options), options, 4, [](double) {});
            ++runs;
            const double told = std::hypot(patches, *found.relative_standard_error);
            covered += exact_error(scene, found.radiosity).root() <= told ? 1 : 0;
        }
    }
    CHECK(runs == 60);
    CHECK(covered >= 54);
}

} // namespace refinement_test
