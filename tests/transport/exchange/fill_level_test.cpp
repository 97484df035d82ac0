#include "transport/exchange/ray_allocation.h"

#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace fill_level_test {

using namespace multipath;

namespace {

struct Vessel
{
    double importance;
    double lines;
};

/// Importance and lines spread over so many powers of ten; every eighth vessel is empty.
std::vector<Vessel> some_vessels(std::uint64_t key, std::size_t count, double spread)
{
    std::vector<Vessel> vessels;
    for (std::size_t k = 0; k < count; ++k) {
        const auto power = [&](std::uint64_t counter) {
            return std::pow(10.0, spread * (bits_to_unit(random_bits(key, counter)) - 0.5));
        };
        vessels.push_back({power(2 * k), k % 8 == 0 ? 0.0 : power(2 * k + 1)});
    }
    return vessels;
}

double poured(const std::vector<Vessel>& vessels, double level)
{
    double sum = 0.0;
    for (const Vessel& vessel : vessels)
        sum += std::max(0.0, level * vessel.importance - vessel.lines);
    return sum;
}

/// The level by bisection of its definition.
double exact_level(const std::vector<Vessel>& vessels, double rays)
{
    double low = 0.0;
    double high = 1.0;
    while (poured(vessels, high) < rays)
        high *= 2.0;
    for (int step = 0; step < 200; ++step) {
        const double middle = 0.5 * (low + high);
        (poured(vessels, middle) < rays ? low : high) = middle;
    }
    return high;
}

FillLevel filled(const std::vector<Vessel>& vessels)
{
    FillLevel level;
    for (const Vessel& vessel : vessels)
        level.add(vessel.importance, vessel.lines);
    return level;
}

} // namespace

// Depths are told apart by a sixteenth. Within the class of the true level some vessels count as reached that are not:
// the level found lies in the same class, above the true one.
TEST_CASE("the level is the one of the definition, at most a sixteenth above")
{
    for (std::uint64_t key = 1; key <= 20; ++key)
        for (const double spread : {0.1, 2.0, 8.0})
            for (const double rays : {1e-2, 1.0, 1e3, 1e6}) {
                CAPTURE(key);
                CAPTURE(spread);
                CAPTURE(rays);
                const std::vector<Vessel> vessels = some_vessels(key, 100, spread);
                const double exact = exact_level(vessels, rays);
                const double level = filled(vessels).level(rays);
                CHECK(level >= exact * (1.0 - 1e-12));
                CHECK(level <= exact * (1.0 + 1.0 / 16.0));
            }
}

// The worst case: nearly all the importance is just above the level, as deep as the class goes or a little deeper.
TEST_CASE("vessels just above the level raise it by a sixteenth at most")
{
    for (const double depth : {1.02, 1.06, 1.1, 1.12, 1.18, 1.24}) {
        CAPTURE(depth);
        const std::vector<Vessel> vessels = {{1.0, 1.0}, {100.0, 100.0 * depth}};
        const double level = filled(vessels).level(0.01); // 1.01 by the definition
        CHECK(level >= 1.01 * (1.0 - 1e-12));
        CHECK(level <= 1.01 * (1.0 + 1.0 / 16.0));
    }
}

// Only the vessels of one class of depths are misjudged, one of dozens when they are spread over orders of magnitude.
TEST_CASE("the vessels take the rays together, to a few percent")
{
    for (std::uint64_t key = 1; key <= 20; ++key)
        for (const double rays : {1e2, 1e4, 1e6}) {
            CAPTURE(key);
            CAPTURE(rays);
            const std::vector<Vessel> vessels = some_vessels(key, 1000, 6.0);
            CHECK(poured(vessels, filled(vessels).level(rays)) == doctest::Approx(rays).epsilon(0.03));
        }
}

TEST_CASE("one vessel takes all rays, and none has no level")
{
    for (const Vessel vessel : {Vessel{3.0, 0.0}, Vessel{3.0, 6.0}, Vessel{1e-9, 1e6}, Vessel{1e9, 1e-6}}) {
        CAPTURE(vessel.importance);
        const double level = filled({vessel}).level(60.0);
        CHECK(level == doctest::Approx((60.0 + vessel.lines) / vessel.importance).epsilon(1e-12));
    }
    CHECK(FillLevel().level(60.0) == 0.0);
}

// Depth 0 for both: 30 rays in proportion to the importance. Depths 0 and 100: nothing for the second until the first
// has reached 100.
TEST_CASE("empty vessels share in proportion, full ones wait")
{
    CHECK(filled({{1.0, 0.0}, {2.0, 0.0}}).level(30.0) == doctest::Approx(10.0).epsilon(1e-12));
    CHECK(filled({{1.0, 0.0}, {2.0, 200.0}}).level(90.0) == doctest::Approx(90.0).epsilon(1e-12));
    CHECK(filled({{1.0, 0.0}, {2.0, 200.0}}).level(130.0) == doctest::Approx(110.0).epsilon(1e-12));
}

// Sums of doubles in another order: 1e-12.
TEST_CASE("vessels added in parts are all there")
{
    const std::vector<Vessel> vessels = some_vessels(5, 100, 4.0);
    FillLevel sum = filled({vessels.begin(), vessels.begin() + 37});
    sum.add(filled({vessels.begin() + 37, vessels.end()}));
    CHECK(sum.level(50.0) == doctest::Approx(filled(vessels).level(50.0)).epsilon(1e-12));
}

} // namespace fill_level_test
