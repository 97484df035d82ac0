// The weights of rays between two patches average to the exchange between them: A_1 A_2 / pi times the mean of
// cos cos' / r^2 over pairs of points, or A_1 / pi times the mean of solid angle times cosine.

#include "transport/exchange/pair_rays.h"

#include "geometry/form_factor/exchange_area.h"
#include "statistics.h"
#include "test_scenes.h"

#include <algorithm>
#include <doctest/doctest.h>

namespace ray_pair_test {

using namespace multipath;

namespace {

constexpr double pi = 3.14159265358979323846;

Scene two_patches(const Surface& one, const Surface& other)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    return builder.surface(one, grey).surface(other, grey).scene(1e6);
}

/// Mean and standard error of the weights, and the largest one.
struct Weights
{
    Estimate mean;
    double largest;
};

Weights weights(const Scene& scene)
{
    const RayPair pair(scene, 0, 1);
    const std::unique_ptr<Sequence> random = make_sequence("random", 7);
    std::vector<double> samples;
    for (std::uint64_t k = 0; k < 100000; ++k)
        samples.push_back(pair.ray(random->item(k)).weight);
    return {estimate(samples), *std::max_element(samples.begin(), samples.end())};
}

const Surface unit_square = {Shape::parallelogram, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}}; // looks to +y

} // namespace

TEST_CASE("far from each other, the mean weight is the exchange over both areas")
{
    for (const Shape shape : {Shape::parallelogram, Shape::triangle}) {
        const Surface other = {shape, {1, 5, 0}, {2, 0.5, 0}, {0, 0, 1}};
        const Scene scene = two_patches(unit_square, other);
        const double exact = pi * exchange_area(unit_square, other, 1e-9) / (scene.area(0) * scene.area(1));
        CHECK(exact > 0.0);
        CHECK(weights(scene).mean.agrees_with(exact));
    }
}

TEST_CASE("of patches that touch, the mean weight is the exchange over the smaller area, and none exceeds pi")
{
    for (const Shape shape : {Shape::parallelogram, Shape::triangle}) {
        const Surface wall = {shape, {0, 0, 0}, {0.9, 0, 0}, {0, 0.8, 0}}; // shares an edge, looks to +z
        const Scene scene = two_patches(unit_square, wall);
        const Weights found = weights(scene);
        const double smaller = std::min(scene.area(0), scene.area(1));
        CHECK(found.mean.agrees_with(pi * exchange_area(unit_square, wall, 1e-9) / smaller));
        CHECK(found.largest <= pi * (1.0 + 1e-12));
    }
}

TEST_CASE("patches that are turned away from each other have no ray of any weight")
{
    const Surface behind = {Shape::parallelogram, {0, -1, 0}, {0, 0, 1}, {1, 0, 0}};
    CHECK(weights(two_patches(unit_square, behind)).largest == 0.0);
}

} // namespace ray_pair_test
