#include "image/colour_scale.h"

#include "image/tone_map.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace legend_test {

using namespace multipath;

namespace {

const std::string title = "standard error of the radiosity [W/m\xB2]";

double read_back(const std::string& number)
{
    return std::strtod(number.c_str(), nullptr);
}

const std::string characters = "abcdefghijklmnopqrstuvwxyzW0123456789.+-/[]\xB2";

ScreenImage black(int width, int height)
{
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 0)};
}

std::uint8_t red(const ScreenImage& picture, int x, int y)
{
    return picture.bytes[static_cast<std::size_t>(3 * (y * picture.width + x))];
}

} // namespace

TEST_CASE("scales as a person would choose them")
{
    CHECK(round_scale(0.0048).number(5) == "0.005");
    CHECK(round_scale(0.0048).number(1) == "0.001");
    CHECK(round_scale(11.0).number(1) == "2.5");
    CHECK(round_scale(11.0).number(5) == "12.5");
    CHECK(round_scale(0.11).number(2) == "0.050");
    CHECK(round_scale(100.0).number(5) == "100");
    CHECK(round_scale(130.0).number(3) == "150");
    CHECK(round_scale(160.0).number(4) == "200");
    CHECK(round_scale(3.3e-8).number(4) == "4e-8");
    CHECK(round_scale(2.9e9).number(3) == "3e9");
    CHECK(round_scale(0.0).top() == 1.0);
}

// What gives away most is a reach just beyond three steps, which takes a fourth.
TEST_CASE("a scale reaches just far enough, in three to five steps, and its numbers say where they stand")
{
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const double reach = std::pow(10.0, -30.0 + 60.0 * bits_to_unit(random_bits(7, i)));
        const LegendScale scale = round_scale(reach);
        INFO("reach ", reach);
        CHECK(scale.steps >= 3);
        CHECK(scale.steps <= 5);
        CHECK(scale.top() >= reach * (1.0 - 1e-8));
        CHECK(scale.top() <= 4.0 / 3.0 * reach * (1.0 + 1e-12));
        CHECK(scale.number(0) == "0");
        for (int step = 1; step <= scale.steps; ++step)
            CHECK(read_back(scale.number(step)) ==
                  doctest::Approx(scale.top() * step / scale.steps).epsilon(1e-12).scale(0.0));
    }
}

TEST_CASE("a legend leaves most of the picture and needs room to be read")
{
    for (int height = 1; height < 3000; height += 7)
        for (const int width : {60, 320, 800, 4000})
            CHECK(3 * legend_height(width, height, title) <= height);
    CHECK(legend_height(320, 240, title) > 0);
    CHECK(legend_height(800, 600, title) == 2 * legend_height(320, 240, title));
    CHECK(legend_height(80, 600, title) == 0);
    CHECK(legend_height(800, 60, title) == 0);
}

// Along the row in the middle of the bar: its first and last colour, and on both sides of it paper.
TEST_CASE("the bar of colours runs from the start of the map to its end")
{
    const int height = legend_height(640, 480, title);
    const ScreenImage strip = legend_strip(640, height, {title, round_scale(1.0)});
    REQUIRE(strip.bytes.size() == static_cast<std::size_t>(3 * 640 * height));
    const auto is = [&](int x, int y, double share) {
        const std::uint8_t* pixel = &strip.bytes[static_cast<std::size_t>(3 * (640 * y + x))];
        const Rgb colour = map_colour(share);
        // A column is up to a share of 1/500 from the end, less than two bytes of any channel.
        return std::abs(pixel[0] - screen_byte(colour.r)) <= 2 && std::abs(pixel[1] - screen_byte(colour.g)) <= 2 &&
               std::abs(pixel[2] - screen_byte(colour.b)) <= 2;
    };
    const int y = height / 2;
    int first = 0;
    while (first < 640 && !is(first, y, 0.0))
        ++first;
    int last = 639;
    while (last > 0 && !is(last, y, 1.0))
        --last;
    REQUIRE(first < last);
    CHECK(last - first > 500);
    for (int x = first; x <= last; ++x)
        CHECK(is(x, y, (x - first + 0.5) / (last - first + 1)));
}

TEST_CASE("a plus after the last number says that there are values beyond")
{
    const int height = legend_height(640, 480, title);
    const ScreenImage closed = legend_strip(640, height, {title, round_scale(1.0)});
    const ScreenImage open = legend_strip(640, height, {title, round_scale(1.0), true});
    CHECK(closed.bytes != open.bytes);
    for (int y = 0; y < height; ++y) { // of five steps the last begins at four fifths
        const auto row = [&](const ScreenImage& strip) { return strip.bytes.begin() + 3 * 640 * y; };
        CHECK(std::equal(row(closed), row(closed) + 3 * 480, row(open)));
    }
}

TEST_CASE("no two characters look alike, and none is blank")
{
    std::set<std::vector<std::uint8_t>> looks = {black(5, font_height).bytes};
    for (const char character : characters) {
        ScreenImage picture = black(5, font_height);
        draw_text(picture, 0, 0, 1, std::string(1, character), 255);
        INFO("character ", character);
        CHECK(looks.insert(picture.bytes).second);
    }
}

TEST_CASE("a text lies within its width and height, and neighbours do not touch")
{
    const int width = text_width(characters);
    ScreenImage picture = black(width + 4, font_height + 4);
    draw_text(picture, 2, 2, 1, characters, 255);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const bool inside = x >= 2 && x < 2 + width && y >= 2 && y < 2 + font_height;
            const bool gap = (x - 2) % 6 == 5;
            if (!inside || gap)
                CHECK(red(picture, x, y) == 0);
        }
}

TEST_CASE("a larger scale repeats every pixel")
{
    ScreenImage plain = black(60, 12);
    ScreenImage large = black(180, 36);
    draw_text(plain, 4, 1, 1, "0.25 W/m\xB2", 200);
    draw_text(large, 12, 3, 3, "0.25 W/m\xB2", 200);
    CHECK(std::count(plain.bytes.begin(), plain.bytes.end(), 200) > 0);
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            CHECK(red(large, x, y) == red(plain, x / 3, y / 3));
}

// The oracle is the middle of a picture that has room for all of it.
TEST_CASE("what does not fit into the picture is cut off")
{
    ScreenImage small = black(10, 8);
    ScreenImage roomy = black(90, 48);
    draw_text(small, -7, -3, 2, "show", 255);
    draw_text(roomy, 33, 17, 2, "show", 255);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            CHECK(red(small, x, y) == red(roomy, x + 40, y + 20));
}

} // namespace legend_test

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
