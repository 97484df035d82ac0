#include "image/false_colour/colour_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace colour_map_test {

using namespace multipath;

namespace {

constexpr int steps = 100;

/// CIE 1976 lightness, 0 ... 100, of a colour on a screen of Rec. 709.
double cie_lightness(Rgb linear)
{
    const double y = 0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b;
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : 24389.0 / 27.0 * y;
}

/// What is left of a colour without one sort of cones (Vienot, Brettel, Mollon 1999): red and green fall together.
Rgb without_long_cones(Rgb c)
{
    const double yellow = 0.11238 * c.r + 0.88762 * c.g;
    return {yellow, yellow, 0.00401 * c.r - 0.00401 * c.g + c.b};
}
Rgb without_medium_cones(Rgb c)
{
    const double yellow = 0.29275 * c.r + 0.70725 * c.g;
    return {yellow, yellow, -0.02234 * c.r + 0.02234 * c.g + c.b};
}

/// How much lighter each of 100 steps along the map is than the one before, through the eyes of `seen`.
template <typename Eye>
std::vector<double> lightness_steps(Eye seen)
{
    std::vector<double> result;
    for (int step = 0; step < steps; ++step)
        result.push_back(cie_lightness(seen(map_colour((step + 1.0) / steps))) -
                         cie_lightness(seen(map_colour(step * 1.0 / steps))));
    return result;
}

} // namespace

// Ottosson's own figures for the corners of sRGB, to their last digit.
TEST_CASE("OKLab has white and the primaries where they are published")
{
    const auto check = [](OkLab colour, Rgb expected) {
        const Rgb found = linear_light(colour);
        CHECK(std::abs(found.r - expected.r) < 1e-4);
        CHECK(std::abs(found.g - expected.g) < 1e-4);
        CHECK(std::abs(found.b - expected.b) < 1e-4);
    };
    check({1.0, 0.0, 0.0}, {1, 1, 1});
    check({0.62796, 0.22486, 0.12585}, {1, 0, 0});
    check({0.86644, -0.23389, 0.17950}, {0, 1, 0});
    check({0.45201, -0.03246, -0.31153}, {0, 0, 1});
}

TEST_CASE("a screen can show every colour of the map, and none is as dark as black")
{
    for (int step = 0; step <= steps; ++step) {
        const Rgb colour = map_colour(step * 1.0 / steps);
        CHECK(std::min({colour.r, colour.g, colour.b}) >= 0.0);
        CHECK(std::max({colour.r, colour.g, colour.b}) <= 1.0);
        CHECK(cie_lightness(colour) > 15.0);
    }
}

// CIE lightness and OKLab's are different models of the eye: they agree on what is even to about a quarter.
TEST_CASE("the map becomes lighter at an even pace")
{
    const std::vector<double> all = lightness_steps([](Rgb c) { return c; });
    const double mean = std::accumulate(all.begin(), all.end(), 0.0) / steps;
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    CHECK(*least > 0.75 * mean);
    CHECK(*most < 1.25 * mean);
}

// Nowhere less than half of the mean pace: two values that differ by a given share of the scale differ visibly at any
// place of it.
TEST_CASE("who cannot tell red from green sees the map become lighter all the same")
{
    for (const std::vector<double>& all :
         {lightness_steps(without_long_cones), lightness_steps(without_medium_cones)}) {
        const double mean = std::accumulate(all.begin(), all.end(), 0.0) / steps;
        CHECK(*std::min_element(all.begin(), all.end()) > 0.5 * mean);
    }
}

TEST_CASE("beyond its ends the map stays what it is there")
{
    CHECK(map_colour(-3.0) == map_colour(0.0));
    CHECK(map_colour(1e300) == map_colour(1.0));
}

} // namespace colour_map_test
