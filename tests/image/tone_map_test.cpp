#include "image/tone_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tone_map_test {

using namespace multipath;

namespace {

Image grey_image(const std::vector<double>& values)
{
    Image image{static_cast<int>(values.size()), 1, {}};
    for (const double value : values)
        image.pixels.push_back({value, value, value});
    return image;
}

/// A thousand luminances from 0.2 to 2: walls in all shades.
std::vector<double> room()
{
    std::vector<double> values;
    for (int i = 0; i < 1000; ++i)
        values.push_back(0.2 * std::pow(10.0, i / 999.0));
    return values;
}

/// Linear light for a byte of sRGB.
double decoded(double byte)
{
    return srgb_decoded(byte / 255.0);
}

double mean_byte(const ScreenImage& image)
{
    return std::accumulate(image.bytes.begin(), image.bytes.end(), 0.0) / static_cast<double>(image.bytes.size());
}

ScreenImage at_automatic_scale(const Image& image, ToneOperator tone)
{
    return tone_map(image, tone, automatic_scale(image.pixels, tone));
}

} // namespace

TEST_CASE("what is not a light becomes black, what is too bright becomes white")
{
    const ScreenImage image =
        tone_map(grey_image({-1.0, 0.0, std::nan(""), 1e300, INFINITY}), ToneOperator::linear, 1.0);
    CHECK(image.bytes == std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255});
}

TEST_CASE("brighter stays brighter, and the white point is where white begins")
{
    for (const NamedToneOperator& named : tone_operators) {
        const ToneOperator tone = named.tone;
        CAPTURE(named.name);
        CHECK(tone_map(grey_image({white_point(tone)}), tone, 1.0).bytes[0] == 255);
        const ScreenImage image = tone_map(grey_image(room()), tone, 0.5 * white_point(tone));
        for (std::size_t i = 3; i < image.bytes.size(); ++i)
            CHECK(image.bytes[i] + 1 >= image.bytes[i - 3]); // dither is less than one step
    }
}

TEST_CASE("light of one channel is exposed by its part of the luminance, of Rec. 709")
{
    const auto scale_of = [](Rgb light) { return automatic_scale(std::vector<Rgb>(12, light), ToneOperator::linear); };
    const double white = scale_of({3, 3, 3});
    CHECK(white == doctest::Approx(0.2126 * scale_of({3, 0, 0})));
    CHECK(white == doctest::Approx(0.7152 * scale_of({0, 3, 0})));
    CHECK(white == doctest::Approx(0.0722 * scale_of({0, 0, 3})));
}

// The mean of every square of 8 x 8 pixels must be the value between two bytes that no single pixel can show, to 1/64.
TEST_CASE("dither keeps shades between two bytes")
{
    Image even{16, 16, {}};
    even.pixels.assign(256, {decoded(100.3), decoded(100.3), decoded(100.3)});
    const ScreenImage image = tone_map(even, ToneOperator::linear, 1.0);
    for (const int left : {0, 3, 8})
        for (const int top : {0, 5, 8}) {
            double sum = 0.0;
            for (int y = top; y < top + 8; ++y)
                for (int x = left; x < left + 8; ++x)
                    sum += image.bytes[3 * static_cast<std::size_t>(16 * y + x)];
            CHECK(std::abs(sum / 64.0 - 100.3) <= 1.0 / 64.0);
        }
}

// Half way between two bytes: the finest pattern there is, so that the grain is not seen.
TEST_CASE("dither of a half is a chessboard")
{
    Image even{8, 8, {}};
    even.pixels.assign(64, {decoded(100.5), decoded(100.5), decoded(100.5)});
    const ScreenImage image = tone_map(even, ToneOperator::linear, 1.0);
    const auto byte = [&](int x, int y) { return image.bytes[3 * static_cast<std::size_t>(8 * y + x)]; };
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            CHECK(byte(x, y) == ((x + y) % 2 == 0 ? byte(0, 0) : byte(1, 0)));
    CHECK(byte(0, 0) + byte(1, 0) == 201);
}

TEST_CASE("the scene's unit of light does not matter")
{
    for (const NamedToneOperator& named : tone_operators) {
        const ToneOperator tone = named.tone;
        CAPTURE(named.name);
        std::vector<double> dim = room();
        for (double& value : dim)
            value *= 0x1p-30; // a power of two keeps every rounding
        const double scale = automatic_scale(grey_image(room()).pixels, tone);
        CHECK(automatic_scale(grey_image(dim).pixels, tone) == doctest::Approx(scale * 0x1p30).epsilon(1e-12));
    }
}

TEST_CASE("an even room is shown in a middle grey")
{
    for (const NamedToneOperator& named : tone_operators) {
        const ToneOperator tone = named.tone;
        if (tone == ToneOperator::percentile) // which is to show it white
            continue;
        CAPTURE(named.name);
        const double shown = decoded(mean_byte(at_automatic_scale(grey_image(std::vector<double>(1000, 3.7)), tone)));
        CHECK(shown > 0.18);
        CHECK(shown < 0.25);
    }
}

TEST_CASE("lamps and black corners do not decide the exposure")
{
    for (const NamedToneOperator& named : tone_operators) {
        const ToneOperator tone = named.tone;
        CAPTURE(named.name);
        const double scale = automatic_scale(grey_image(room()).pixels, tone);
        for (const double lamp : {19.0, 1e6}) { // 30 times the middle, and more
            std::vector<double> values = room();
            values.insert(values.end(), 50, lamp); // 5 %
            values.insert(values.end(), 500, 0.0); // the dark around an open box
            // The middle half moves by 2.5 % of the ranks, which are a decade wide: 6 %.
            CHECK(automatic_scale(grey_image(values).pixels, tone) == doctest::Approx(scale).epsilon(0.07));
            const ScreenImage image = at_automatic_scale(grey_image(values), tone);
            CHECK(image.bytes[3 * 1020] >= 250);
        }
    }
}

TEST_CASE("a black image stays black")
{
    for (const NamedToneOperator& named : tone_operators)
        CHECK(mean_byte(at_automatic_scale(grey_image({0.0, 0.0}), named.tone)) == 0.0);
}

// Two ways to the same byte: without the dither, which moves it by one at most, a picture is the encoded light.
TEST_CASE("the light of a screen is what pictures encode")
{
    for (const NamedToneOperator& named : tone_operators) {
        const ToneOperator tone = named.tone;
        CAPTURE(named.name);
        const Rgb radiosity = {0.02, 0.7, 3.0};
        const Rgb shown = srgb_encoded(screen_light(radiosity, tone, 0.5));
        const ScreenImage image = tone_map({1, 1, {radiosity}}, tone, 0.5);
        CHECK(std::abs(image.bytes[0] - 255.0 * shown.r) <= 1.0);
        CHECK(std::abs(image.bytes[1] - 255.0 * shown.g) <= 1.0);
        CHECK(std::abs(image.bytes[2] - 255.0 * shown.b) <= 1.0);
    }
    CHECK(screen_light({2.0, 0.25, -1.0}, ToneOperator::linear, 1.0) == Rgb{1.0, 0.25, 0.0});
}

// Values published with the standard and in colour science handbooks, to the digits that are printed there.
TEST_CASE("the sRGB transfer function has its published values")
{
    CHECK(srgb_encoded(0.0) == 0.0);
    CHECK(srgb_encoded(1.0) == 1.0);
    CHECK(srgb_encoded(0.0031308) == doctest::Approx(0.04045).epsilon(1e-4)); // the joint of line and power
    CHECK(srgb_encoded(0.18) == doctest::Approx(0.4614).epsilon(1e-4));       // a grey card is byte 118
    CHECK(srgb_encoded(0.5) == doctest::Approx(0.7354).epsilon(1e-4));        // half the light is byte 188
    CHECK(srgb_decoded(0.04045) == doctest::Approx(0.0031308).epsilon(1e-4));
    CHECK(srgb_decoded(0.5) == doctest::Approx(0.21404).epsilon(1e-4));
}

TEST_CASE("what is encoded is decoded again")
{
    for (double x = 0.0; x <= 1.0; x += 1.0 / 256.0)
        CHECK(srgb_decoded(srgb_encoded(x)) == doctest::Approx(x).epsilon(1e-5)); // the standard's pieces meet so well
}

// The encoded value of linear 0.5 is 0.73536 (IEC 61966-2-1), 187.5 of 255.
TEST_CASE("linear light becomes the nearest byte of sRGB")
{
    CHECK(screen_byte(0.0) == 0);
    CHECK(screen_byte(0.499) == 187);
    CHECK(screen_byte(0.501) == 188);
    CHECK(screen_byte(1.0) == 255);
}

} // namespace tone_map_test
