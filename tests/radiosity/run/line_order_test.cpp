// What a line carries depends on the lines before it, so the order of quasi-random lines matters: with few patches the
// successive lines through one patch are correlated. The oracle is line reuse, which in a convex room has exact form
// factors (laws_test).

#include "radiosity/run/solve.h"
#include "test_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>

namespace line_order_test {

using namespace multipath;

namespace {

const ProgressCallback silent = [](double) {};

Scene uneven_cube()
{
    const std::array<double, 6> rho = {0.2, 0.7, 0.5, 0.3, 0.9, 0.6};
    const std::array<double, 6> emittance = {0.0, 3.0, 0.0, 0.0, 1.0, 0.0};
    SceneBuilder builder;
    std::vector<std::uint32_t> walls;
    for (std::size_t i = 0; i < 6; ++i)
        walls.push_back(builder.grey(rho[i], emittance[i]));
    return builder.room({0, 0, 0}, {1, 1, 1}, walls).scene(1.0);
}

} // namespace

TEST_CASE("walks along shuffled quasi-random lines converge to the solution, along lines in order beside it" *
          doctest::test_suite("statistics"))
{
    const Scene scene = uneven_cube();
    SolveOptions options;
    options.lines = 1u << 20;
    options.threads = 2;
    options.method = Method::reuse;
    const std::vector<Rgb> exact = solve(scene, options, silent).radiosity;
    options.method = Method::global;
    const auto largest_error = [&](LineOrder order) {
        options.line_order = order;
        const std::vector<Rgb> found = solve(scene, options, silent).radiosity;
        double largest = 0.0;
        for (std::size_t i = 0; i < exact.size(); ++i)
            largest = std::max(largest, std::abs(found[i].r / exact[i].r - 1.0));
        return largest;
    };
    for (const char* sequence : {"sobol", "halton", "halton:11,13,17,19", "kronecker"}) {
        CAPTURE(sequence);
        options.sequence = sequence;
        const double shuffled = largest_error(LineOrder::shuffled);
        const double in_order = largest_error(LineOrder::sequence);
        CHECK(shuffled < 0.002);
        CHECK(in_order > 0.01);
    }
}

} // namespace line_order_test
