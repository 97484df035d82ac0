// Light takes the colour of what reflects it, so a white floor is reddest next to a red wall: by how much is known in
// closed form where all form factors are, and in which direction in any room.

#include "form_factor.h"
#include "radiosity/run/solve.h"
#include "scene/obj/obj_reader.h"
#include "statistics.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace colour_bleed_test {

using namespace multipath;

namespace {

const std::array<Method, 4> paper_methods = {Method::local, Method::global, Method::first_shot, Method::extended};

/// Runs of different methods take different seeds.
int number_of(Method method)
{
    return static_cast<int>(std::find(paper_methods.begin(), paper_methods.end(), method) - paper_methods.begin());
}

constexpr std::array<double Rgb::*, 3> channels = {&Rgb::r, &Rgb::g, &Rgb::b};

std::vector<Solution> solve_repeatedly(const Scene& scene, Method method, std::uint64_t lines, int runs)
{
    std::vector<Solution> solutions;
    for (int k = 1; k <= runs; ++k) {
        SolveOptions options;
        options.method = method;
        options.sequence = "random";
        options.lines = lines;
        options.ratio = 0.5; // spares the pilot that would measure the best one
        options.seed = static_cast<std::uint64_t>(runs * number_of(method) + k);
        solutions.push_back(solve(scene, options, [](double) {}));
    }
    return solutions;
}

template <class Quantity>
Estimate estimate_of(const std::vector<Solution>& solutions, const Quantity& quantity)
{
    std::vector<double> samples;
    for (const Solution& solution : solutions)
        samples.push_back(quantity(solution));
    return estimate(samples);
}

// Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-14: from a rectangle of width w and length 1 to
// one of height 1 that stands on its edge at a right angle. Times w [m^2] it is the exchange area A F, the same from
// both sides.
double exchange_area_at_right_angle(double w)
{
    const double w2 = w * w;
    const double d2 = 1.0 + w2;
    const double angles = w * std::atan(1.0 / w) + std::atan(1.0) - std::sqrt(d2) * std::atan(1.0 / std::sqrt(d2));
    const double sum = 1.0 + d2;
    const double logs = std::log(2.0 * d2 / sum) + w2 * std::log(w2 * sum / (d2 * d2)) + std::log(sum / (2.0 * d2));
    return (angles + 0.25 * logs) / 3.14159265358979323846;
}

/// A unit cube: a lamp wall at x = 1 and a red wall at x = 0 face each other, four white strips of the floor lie
/// between them, the rest is black. One patch each, in this order: lamp, red wall, strips from the red wall on, black
/// walls.
struct RedCorner
{
    static constexpr std::uint32_t strips = 4;
    static constexpr std::uint32_t lit = 2 + strips;

    Scene scene() const
    {
        SceneBuilder builder;
        const std::uint32_t lamp = builder.material({0.4, 0.4, 0.4}, {3, 2, 1});
        const std::uint32_t red = builder.material({0.9, 0.2, 0.1}, {});
        const std::uint32_t white = builder.grey(0.8, 0.0);
        const std::uint32_t black = builder.grey(0.0, 0.0);
        builder.rectangle({1, 0, 0}, {0, 0, 1}, {0, 1, 0}, lamp);
        builder.rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, red);
        for (std::uint32_t k = 0; k < strips; ++k)
            builder.rectangle({k / double{strips}, 0, 0}, {0, 0, 1}, {1.0 / strips, 0, 0}, white);
        builder.rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, black);
        builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, black);
        builder.rectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, black);
        return builder.scene(10.0);
    }

    /// A_i F_ij [m^2] of the patches that send light, i < j. A strip's is the difference of two floors that begin at
    /// the wall; strips do not see each other.
    static double exchange_area(std::uint32_t i, std::uint32_t j)
    {
        if (i == 0 && j == 1)
            return opposite_form_factor();
        if (i >= 2)
            return 0.0;
        const std::uint32_t from_wall = i == 1 ? j - 2 : strips - 1 - (j - 2);
        const auto up_to = [](std::uint32_t k) {
            return k == 0 ? 0.0 : exchange_area_at_right_angle(k / double{strips});
        };
        return up_to(from_wall + 1) - up_to(from_wall);
    }

    /// The solution of B_i = E_i + rho_i sum_j F_ij B_j. Less than half of the light survives a step of the iteration.
    static std::vector<Rgb> exact(const Scene& scene)
    {
        std::vector<Rgb> radiosity(lit);
        for (int step = 0; step < 100; ++step)
            for (std::uint32_t i = 0; i < lit; ++i) {
                Rgb incident;
                for (std::uint32_t j = 0; j < lit; ++j)
                    if (i != j)
                        incident += exchange_area(std::min(i, j), std::max(i, j)) * radiosity[j];
                radiosity[i] = scene.emittance(i) + (1.0 / scene.area(i)) * (scene.reflectance(i) * incident);
            }
        return radiosity;
    }
};

} // namespace

// 24 runs each; among the 96 comparisons one exceeds 4 standard errors by chance in at most one of 18 choices of seeds.
TEST_CASE("the floor is redder the nearer it is to a red wall, by the closed form, with every method")
{
    CHECK(exchange_area_at_right_angle(1.0) == doctest::Approx((1.0 - opposite_form_factor()) / 4.0).epsilon(1e-12));
    const Scene scene = RedCorner().scene();
    const std::vector<Rgb> exact = RedCorner::exact(scene);
    const auto redness = [](Rgb b) { return b.r / b.g; };
    for (std::uint32_t i = 2; i + 1 < RedCorner::lit; ++i)
        CHECK(redness(exact[i]) > redness(exact[i + 1]));
    for (const Method method : paper_methods) {
        const std::vector<Solution> solutions = solve_repeatedly(scene, method, 1u << 13, 24);
        for (std::uint32_t i = 0; i < RedCorner::lit; ++i) {
            CAPTURE(i);
            for (const auto channel : channels)
                CHECK(estimate_of(solutions, [&](const Solution& s) {
                          return s.radiosity[i].*channel;
                      }).agrees_with(exact[i].*channel));
            CHECK(estimate_of(solutions, [&](const Solution& s) {
                      return redness(s.radiosity[i]);
                  }).agrees_with(redness(exact[i])));
        }
    }
}

// No light comes to the ceiling straight from the lamp, which hangs below it. What white surfaces alone send there is
// at least as red as the lamp's own light (100 to 85), for white reflects red no less than green. So only the green
// wall can make it less red. Every white reflection adds 1.4 %; 7 % would take five, or the red wall.
TEST_CASE("the ceiling of the Cornell box is redder than the lamp at the red wall and greener at the green one")
{
    const Scene scene(read_obj("scenes/cornell.obj"), 0.11);
    const auto redness = [&](const Solution& solution, double from, double to) {
        Rgb sum;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const Vec3 centre = scene.patch(i).shape.centre();
            if (centre.y > 0.5499 && centre.x > from && centre.x < to && scene.patch(i).shape.normal().y < 0.0)
                sum += solution.radiosity[i];
        }
        return sum.r / sum.g;
    };
    for (const Method method : paper_methods) {
        const std::vector<Solution> solutions = solve_repeatedly(scene, method, 1u << 15, 6);
        const Estimate at_red = estimate_of(solutions, [&](const Solution& s) { return redness(s, 0.0, 0.11); });
        const Estimate at_green = estimate_of(solutions, [&](const Solution& s) { return redness(s, 0.44, 0.55); });
        CHECK(at_red.mean - 4.0 * at_red.standard_error > 1.07 * 100.0 / 85.0);
        CHECK(at_green.mean + 4.0 * at_green.standard_error < 100.0 / 85.0);
    }
}

} // namespace colour_bleed_test
