// The methods solve the same equations in different ways: particles that leave the sources and walk from patch to
// patch, and power that lines through the whole scene carry, with and without a first shot. They share the intersector
// and the random numbers but little else, so what one of them counts wrongly shows as a difference.
//
// Every method runs with seeds of its own. Objects are compared by the mean of B - E, per channel, in standard errors
// of the difference; each method is judged by the largest of all. What the walk leaves unshot makes it a little too
// dark, and that is made up for: the missing light is that of the same scene lit by the unshot power alone.

#include "radiosity/run/solve.h"
#include "scene/obj/obj_reader.h"
#include "statistics.h"
#include "transport/lines/global_lines.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace method_agreement_test {

using namespace multipath;

namespace {

const ProgressCallback silent = [](double) {};
const std::array<Method, 3> line_methods = {Method::global, Method::first_shot, Method::extended};
const std::array<Method, 6> compared_methods = {Method::global, Method::first_shot,        Method::extended,
                                                Method::jacobi, Method::transillumination, Method::gathering};
constexpr std::array<double Rgb::*, 3> channels = {&Rgb::r, &Rgb::g, &Rgb::b};
/// Runs of different methods take different seeds.
int number_of(Method method)
{
    const std::vector<Method> methods = all_methods();
    return static_cast<int>(std::find(methods.begin(), methods.end(), method) - methods.begin());
}

constexpr std::array<const char*, 3> rooms = {"5cubes", "4chairs", "4chairs-up"};

/// A patch size of 100 makes every surface one patch, which meets many lines, so that little is left unshot.
Scene bundled_scene(const std::string& name, double patch_size)
{
    return Scene(read_obj("scenes/" + name + ".obj"), patch_size);
}

SolveOptions random_lines(Method method, std::uint64_t lines, std::uint64_t seed)
{
    SolveOptions options;
    options.method = method;
    options.sequence = "random";
    options.lines = lines;
    options.ratio = 0.5; // spares the pilot that would measure the best one
    options.seed = seed;
    options.threads = 2;
    return options;
}

/// Some patches that are compared as one.
using Region = std::vector<std::uint32_t>;

/// The whole scene, every object of at least 1 % of the area, and the smaller ones together.
std::vector<Region> regions_of(const Scene& scene)
{
    std::vector<Region> objects(scene.file().groups.size());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        objects[scene.file().group[scene.surface_of(i)]].push_back(i);
    std::vector<Region> regions(2);
    for (const Region& object : objects) {
        double area = 0.0;
        for (const std::uint32_t i : object)
            area += scene.area(i);
        regions[0].insert(regions[0].end(), object.begin(), object.end());
        if (area >= 0.01 * scene.total_area())
            regions.push_back(object);
        else
            regions[1].insert(regions[1].end(), object.begin(), object.end());
    }
    if (regions[1].empty())
        regions.erase(regions.begin() + 1);
    return regions;
}

/// Mean of B - E over the area of a region [W/m^2].
Rgb mean_reflected(const Scene& scene, const Region& region, const std::vector<Rgb>& radiosity)
{
    Rgb power;
    double area = 0.0;
    for (const std::uint32_t i : region) {
        power += scene.area(i) * (radiosity[i] - scene.emittance(i));
        area += scene.area(i);
    }
    return (1.0 / area) * power;
}

/// Crossings per area [1/m^2] by the lines of a solution (G1).
double line_density(const Scene& scene, const Solution& solution)
{
    return GlobalLines(scene.bounds()).expected_crossings(1.0, solution.global_lines_cast);
}

/// A patch holds what its last line brought it, in expectation the share 1 / (its lines) of what it reflected: the
/// power [W] that patches hold where global lines brought all of it.
std::vector<Rgb> last_line_power(const Scene& scene, const std::vector<Rgb>& radiosity, double density)
{
    std::vector<Rgb> held;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        held.push_back((1.0 / density) * (radiosity[i] - scene.emittance(i)));
    return held;
}

/// What several runs of one method found.
struct Runs
{
    std::vector<std::vector<Rgb>> reflected; ///< [W/m^2] of every region and run
    std::vector<Rgb> radiosity;              ///< [W/m^2] of every patch, mean of the runs
    Rgb unshot;                              ///< [W] mean of the runs
    double density = 0.0;                    ///< [1/m^2] see line_density
};

Runs run(const Scene& scene, const std::vector<Region>& regions, Method method, std::uint64_t lines, int count)
{
    Runs runs;
    runs.reflected.resize(regions.size());
    runs.radiosity.resize(scene.patch_count());
    for (int k = 0; k < count; ++k) {
        const auto seed = static_cast<std::uint64_t>(count * number_of(method) + k + 1);
        const Solution solution = solve(scene, random_lines(method, lines, seed), silent);
        for (std::size_t r = 0; r < regions.size(); ++r)
            runs.reflected[r].push_back(mean_reflected(scene, regions[r], solution.radiosity));
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            runs.radiosity[i] += (1.0 / count) * solution.radiosity[i];
        runs.unshot += (1.0 / count) * solution.balance.unshot;
        runs.density = line_density(scene, solution);
    }
    return runs;
}

/// The radiosity that the power left unshot would still have given to every region [W/m^2]. The sum of that power is
/// reported. Its distribution is that of last_line_power; after the extended first shot, which leaves every patch the
/// same radiosity for the lines to carry, that of a uniform irradiance.
std::vector<Rgb> light_of_unshot(const Scene& scene, const std::vector<Region>& regions, Method method,
                                 const Runs& runs)
{
    std::vector<Rgb> held = last_line_power(scene, runs.radiosity, runs.density);
    Rgb sum;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        if (method == Method::extended)
            held[i] = scene.reflectance(i);
        sum += held[i];
    }
    const Rgb scale = {runs.unshot.r / sum.r, runs.unshot.g / sum.g, runs.unshot.b / sum.b};
    SceneFile file = scene.file();
    file.materials.clear();
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        file.material[i] = i; // every surface is one patch
        file.materials.push_back(scene.material_of(i));
        file.materials.back().emittance = (1.0 / scene.area(i)) * (scale * held[i]);
    }
    const Scene lit_by_unshot(std::move(file), scene.patch_size());
    const std::vector<Rgb> radiosity = solve(lit_by_unshot, random_lines(Method::local, 1u << 15, 1), silent).radiosity;
    std::vector<Rgb> result;
    for (const Region& region : regions)
        result.push_back(mean_reflected(lit_by_unshot, region, radiosity));
    return result;
}

/// Every region and channel in turn.
std::vector<Estimate> corrected_means(const Scene& scene, const std::vector<Region>& regions, Method method,
                                      const Runs& runs)
{
    std::vector<Rgb> missing(regions.size());
    if (runs.unshot != Rgb{})
        missing = light_of_unshot(scene, regions, method, runs);
    std::vector<Estimate> result;
    for (std::size_t r = 0; r < regions.size(); ++r)
        for (const auto channel : channels) {
            std::vector<double> samples;
            for (const Rgb b : runs.reflected[r])
                samples.push_back(b.*channel + missing[r].*channel);
            result.push_back(estimate(samples));
        }
    return result;
}

/// The largest difference in standard errors.
double largest_deviation(const std::vector<Estimate>& a, const std::vector<Estimate>& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double error = std::hypot(a[i].standard_error, b[i].standard_error);
        if (error > 0.0)
            largest = std::max(largest, std::abs(a[i].mean - b[i].mean) / error);
    }
    return largest;
}

} // namespace

// Without what light_of_unshot adds, up to 2 % of a scene's light is missing; with it, the means of 1,400 runs agree
// to their standard error of 0.1 % or less (global: 0.2 %). Here both sides estimate their error from 40 runs: at most
// one comparison in 3,500 exceeds 4 by chance, so at most one in 90 of these checks of 39 comparisons each. A bias of
// 1 % in the local method, the first shot or the extended one is found, of 5 % in the global one, whose few lines
// through a small lamp make it ten times as noisy.
TEST_CASE("all methods give every object the same light as particles do" * doctest::test_suite("statistics"))
{
    for (const std::string name : rooms) {
        CAPTURE(name);
        const Scene scene = bundled_scene(name, 100.0);
        const std::vector<Region> regions = regions_of(scene);
        const auto found = [&](Method method) {
            return corrected_means(scene, regions, method, run(scene, regions, method, 1u << 14, 40));
        };
        const std::vector<Estimate> by_particles = found(Method::local);
        for (const Method method : compared_methods) {
            CAPTURE(method->name);
            CHECK(largest_deviation(found(method), by_particles) < 4.0);
        }
    }
}

// The radiosity that last_line_power is taken from lacks the light of what is unshot: it is too small by about that
// share of itself. With the cube, 10 % more or less is noticed.
TEST_CASE("global lines leave unshot what the last of them brought to every patch")
{
    for (const std::string name : {"cube", "4chairs", "4chairs-up"}) {
        CAPTURE(name);
        const Scene scene = bundled_scene(name, name == "cube" ? 0.1 : 0.25);
        std::vector<double> ratios;
        std::vector<double> shares;
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Solution solution = solve(scene, random_lines(Method::global, 1u << 15, seed), silent);
            double expected = 0.0;
            for (const Rgb held : last_line_power(scene, solution.radiosity, line_density(scene, solution)))
                expected += mean(held);
            ratios.push_back(mean(solution.balance.unshot) / expected);
            shares.push_back(mean(solution.balance.unshot) / mean(solution.balance.emitted));
        }
        const Estimate ratio = estimate(ratios);
        CAPTURE(ratio.mean);
        CHECK(std::abs(ratio.mean - 1.0) <= 4.0 * ratio.standard_error + estimate(shares).mean);
    }
}

// Patches of about equal area hold 1 / (lines per patch) of what they reflect, and the light is reflected once or
// twice. Global lines alone leave more in 4chairs-up, where much of it goes to and fro between the small patches of the
// lamp.
TEST_CASE("what is left unshot is less than 2 / (lines per patch)")
{
    for (const std::string name : rooms) {
        CAPTURE(name);
        const Scene scene = bundled_scene(name, 0.25);
        for (const Method method : line_methods)
            for (const std::uint64_t lines : {1u << 14, 1u << 15, 1u << 16}) {
                if (method == Method::global && name == "4chairs-up")
                    continue;
                CAPTURE(method->name);
                CAPTURE(lines);
                const Solution solution = solve(scene, random_lines(method, lines, 1), silent);
                const double lines_per_patch = line_density(scene, solution) * scene.total_area() / scene.patch_count();
                const double left = mean(solution.balance.unshot) / mean(solution.balance.emitted);
                CAPTURE(left * lines_per_patch);
                CHECK(left < 2.0 / lines_per_patch);
            }
    }
}

} // namespace method_agreement_test
