// Lines from the sphere and lines from the box have the same density, so the same light must come out.

#include "radiosity/run/solve.h"
#include "scene/obj/obj_reader.h"
#include "statistics.h"
#include "test_scenes.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>

namespace chord_agreement_test {

using namespace multipath;

namespace {

constexpr int seeds = 40;

SolveOptions lines_from(Chords chords, Method method, std::uint64_t lines)
{
    SolveOptions options;
    options.method = method;
    options.sequence = "random";
    options.chords = chords;
    options.lines = lines;
    options.ratio = 0.5; // spares the pilot that would measure the best one
    options.threads = 2;
    return options;
}

/// Mean radiosity of all patches of every group, over independent seeds that begin after `first_seed` [W/m^2].
std::vector<Estimate> light_of_groups(const Scene& scene, SolveOptions options, std::uint64_t first_seed)
{
    std::vector<std::vector<double>> samples(scene.file().groups.size());
    for (int k = 1; k <= seeds; ++k) {
        options.seed = first_seed + static_cast<std::uint64_t>(k);
        const Solution solution = solve(scene, options, [](double) {});
        std::vector<double> power(samples.size());
        std::vector<double> area(samples.size());
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const std::uint32_t group = scene.file().group[scene.surface_of(i)];
            power[group] += scene.area(i) * mean(solution.radiosity[i]);
            area[group] += scene.area(i);
        }
        for (std::size_t g = 0; g < samples.size(); ++g)
            if (area[g] > 0.0)
                samples[g].push_back(power[g] / area[g]);
    }
    std::vector<Estimate> light;
    for (const std::vector<double>& of_group : samples)
        if (!of_group.empty())
            light.push_back(estimate(of_group));
    return light;
}

/// Radiosities of floor, ceiling and side walls of the unit cube whose ceiling alone emits, with one reflectance.
/// Opposite walls see F of each other (Howell, C-11), neighbours (1 - F) / 4; the iteration contracts by rho.
std::array<double, 3> light_in_cube(double rho, double emittance)
{
    const double opposite = 0.19982489569838746;
    const double beside = (1.0 - opposite) / 4.0;
    double floor = 0.0;
    double ceiling = 0.0;
    double side = 0.0;
    for (int pass = 0; pass < 200; ++pass) {
        const double to_floor = opposite * ceiling + 4.0 * beside * side;
        const double to_ceiling = opposite * floor + 4.0 * beside * side;
        const double to_side = beside * (floor + ceiling) + (opposite + 2.0 * beside) * side;
        floor = rho * to_floor;
        ceiling = emittance + rho * to_ceiling;
        side = rho * to_side;
    }
    return {floor, ceiling, side};
}

} // namespace

// 2^16 lines cross each of the six patches 20,000 times: what they leave unshot is 5e-5 of what is reflected, a tenth
// of the standard error.
TEST_CASE("lines from the box give a closed cube its exact light" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.6, 0.0);
    const std::uint32_t lamp = builder.grey(0.6, 2.0);
    builder.room({0, 0, 0}, {1, 1, 1}, {wall, lamp, wall, wall, wall, wall});
    const Scene scene = builder.scene(1.0);
    const std::array<double, 3> exact = light_in_cube(0.6, 2.0);
    for (const Method method : {Method::global, Method::first_shot}) {
        CAPTURE(method->name);
        std::array<std::vector<double>, 3> samples;
        SolveOptions options = lines_from(Chords::box, method, 1u << 16);
        for (options.seed = 1; options.seed <= seeds; ++options.seed) {
            const Solution solution = solve(scene, options, [](double) {});
            CHECK(solution.global_lines_cast == solution.global_lines);
            for (std::uint32_t part = 0; part < 3; ++part)
                samples[part].push_back(solution.radiosity[part].g);
        }
        for (std::size_t part = 0; part < 3; ++part) {
            CAPTURE(part);
            CAPTURE(estimate(samples[part]).mean);
            CAPTURE(estimate(samples[part]).standard_error);
            CHECK(estimate(samples[part]).agrees_with(exact[part]));
        }
    }
}

// Both kinds cast the same density of lines, so they leave the same share unshot, which cancels in the comparison.
TEST_CASE("lines from the box and from the sphere give every object of a room the same light" *
          doctest::test_suite("statistics"))
{
    const Scene scene(read_obj("scenes/5cubes.obj"), 100.0);
    for (const Method method : {Method::global, Method::extended}) {
        CAPTURE(method->name);
        const std::vector<Estimate> box = light_of_groups(scene, lines_from(Chords::box, method, 1u << 14), 0);
        const std::vector<Estimate> sphere = light_of_groups(scene, lines_from(Chords::sphere, method, 1u << 14), 1000);
        for (std::size_t g = 0; g < box.size(); ++g) {
            CAPTURE(g);
            const double error = std::hypot(box[g].standard_error, sphere[g].standard_error);
            CHECK(std::abs(box[g].mean - sphere[g].mean) <= 4.0 * error);
        }
    }
}

TEST_CASE("without a choice the methods of the paper draw their lines from the sphere")
{
    SceneBuilder builder;
    const Scene scene = builder.room({0, 0, 0}, {1, 2, 3}, builder.grey(0.3, 1.4)).scene(1.0);
    SolveOptions options = lines_from(Chords::sphere, Method::global, 1000);
    const std::vector<Rgb> sphere = solve(scene, options, [](double) {}).radiosity;
    options.chords.reset();
    CHECK(solve(scene, options, [](double) {}).radiosity == sphere);
    options.chords = Chords::box;
    CHECK(solve(scene, options, [](double) {}).radiosity != sphere);
}

} // namespace chord_agreement_test
