#include "radiosity/reuse/exchange_solver.h"

#include "sampling/random.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace distribution_test {

using namespace multipath;

namespace {

Scene room_of_three()
{
    SceneBuilder builder;
    const std::uint32_t white = builder.grey(1.0, 0.0);
    const std::uint32_t black = builder.grey(0.0, 1.0);
    const std::uint32_t coloured = builder.material({0.2, 0.5, 0.8}, {});
    return builder.room({0, 0, 0}, {1, 2, 3}, {coloured, white, black, coloured, coloured, coloured}).scene(0.4);
}

double absorbed(const Scene& scene, const PowerState& state)
{
    double sum = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        sum += (1.0 - scene.reflectance(i).r) * state.incident[i].r;
    return sum;
}

/// Area times the squared difference of irradiance.
double squared_error(const Scene& scene, const PowerState& a, const PowerState& b)
{
    double sum = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        sum += std::pow(a.incident[i].r - b.incident[i].r, 2) / scene.area(i);
    return sum;
}

} // namespace

// Any truth without negative light and any noise that leaves the absorbed power alone: the projection comes nearer.
TEST_CASE("removing negative light keeps the power absorbed and brings the irradiance nearer to the truth")
{
    const Scene scene = room_of_three();
    const std::uint32_t n = scene.patch_count();
    for (std::uint64_t key = 1; key <= 50; ++key) {
        const auto random = [&](std::uint64_t k) { return bits_to_unit(random_bits(key, k)); };
        PowerState truth(scene);
        PowerState noisy(scene);
        for (std::uint32_t i = 0; i < n; ++i) {
            truth.incident[i].r = scene.area(i) * std::max(0.0, random(i) - 0.5);
            noisy.incident[i].r = truth.incident[i].r + 0.3 * scene.area(i) * (random(n + i) - 0.5);
        }
        double weight = 0.0;
        for (std::uint32_t i = 0; i < n; ++i)
            weight += (1.0 - scene.reflectance(i).r) * scene.area(i);
        const double shift = (absorbed(scene, truth) - absorbed(scene, noisy)) / weight;
        for (std::uint32_t i = 0; i < n; ++i)
            noisy.incident[i].r += shift * scene.area(i);

        PowerState projected = noisy;
        remove_negative_light(scene, projected);
        for (std::uint32_t i = 0; i < n; ++i)
            CHECK(projected.incident[i].r >= 0.0);
        CHECK(absorbed(scene, projected) == doctest::Approx(absorbed(scene, truth)).epsilon(1e-12));
        CHECK(squared_error(scene, projected, truth) < squared_error(scene, noisy, truth));
        PowerState again = projected;
        remove_negative_light(scene, again);
        CHECK(again.incident == projected.incident);
    }
}

TEST_CASE("irradiance that is nowhere negative stays as it is, bit for bit")
{
    const Scene scene = room_of_three();
    PowerState state(scene);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        state.incident[i] = {0.0, 0.1 * i, 1.0 / (1.0 + i)};
    const std::vector<Rgb> before = state.incident;
    remove_negative_light(scene, state);
    CHECK(state.incident == before);
}

// What cannot be taken from the other kind has arrived at patches: they absorb so much less.
TEST_CASE("negative losses are taken from the other kind, or else from the irradiance")
{
    const Scene scene = room_of_three();
    for (const double escaped : {-2.0, 1.0, 3.0})
        for (const double behind : {-2.0, 1.0, 3.0}) {
            PowerState state(scene);
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                state.incident[i].r = 20.0 + i;
            state.escaped.r = escaped;
            state.behind.r = behind;
            const double before = absorbed(scene, state);
            remove_negative_light(scene, state);
            CHECK(state.escaped.r >= 0.0);
            CHECK(state.behind.r >= 0.0);
            CHECK(state.escaped.r <= std::max(0.0, escaped));
            CHECK(state.behind.r <= std::max(0.0, behind));
            CHECK(state.escaped.r + state.behind.r == std::max(0.0, escaped + behind));
            CHECK(absorbed(scene, state) + state.escaped.r + state.behind.r ==
                  doctest::Approx(before + escaped + behind).epsilon(1e-12));
            CHECK(state.emitted == PowerState(scene).emitted);
            if (escaped >= 0.0 && behind >= 0.0)
                CHECK(state.escaped.r == escaped);
        }
}

} // namespace distribution_test
