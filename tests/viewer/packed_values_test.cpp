#include "viewer/packed_values.h"

#include "sampling/random.h"
#include "viewer/typed_array.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>

namespace packed_values_test {

using namespace multipath;

namespace {

/// As OpenGL ES 3.0 defines it, section 3.8.3: mantissa * 2^(exponent - 15 - 9).
Rgb decoded(std::uint32_t word)
{
    const double scale = std::pow(2.0, static_cast<double>(word >> 27) - 24.0);
    return {scale * (word & 511), scale * (word >> 9 & 511), scale * (word >> 18 & 511)};
}

} // namespace

TEST_CASE("lists of numbers can be read back as typed arrays")
{
    CHECK(base64_decoded(packed_bytes({0, 1, 255})) == std::string("\0\1\xff", 3));
    CHECK(uint32_array(packed_counts({1, 0x01020304u, 0xfffffffeu})) ==
          std::vector<std::uint32_t>{1, 0x01020304u, 0xfffffffeu});
    CHECK(base64_decoded(packed_counts({0x01020304u})) == "\4\3\2\1"); // the lowest byte first
    CHECK(float32_array(packed_numbers({0.5, -3.25})) == std::vector<float>{0.5f, -3.25f});
    CHECK(std::isnan(float32_array(packed_numbers({std::nan("")})).at(0)));
    CHECK(float32_array(packed_colours({{1, 2, 3}, {4, 5, 6}})) == std::vector<float>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("light of any brightness fits into colours with a shared exponent")
{
    for (const double brightness : {1e-20, 1.0, 65408.0, 65409.0, 1e12}) {
        const PackedLight light = packed_light({{brightness, 0, 0.5 * brightness}, {0, 0, 0}});
        const std::vector<std::uint32_t> words = uint32_array(light.words);
        REQUIRE(words.size() == 2);
        const double scale = light.unit * std::pow(2.0, static_cast<double>(words[0] >> 27) - 24.0);
        // Nine bits of the mantissa: 1/512 of it at most.
        CHECK(scale * (words[0] & 511) == doctest::Approx(brightness).epsilon(1.0 / 512));
        CHECK(scale * (words[0] >> 18 & 511) == doctest::Approx(0.5 * brightness).epsilon(1.0 / 256));
        CHECK(words[1] == 0);
    }
}

TEST_CASE("a colour in 32 bits is right to half a step of its brightest channel")
{
    for (std::uint64_t n = 0; n < 10000; ++n) {
        const auto random = [&](std::uint64_t k) { return bits_to_unit(random_bits(n, k)); };
        const double size = std::exp2(28.0 * random(3) - 12.0); // up to 2^16, above the largest at times
        const Rgb colour = {size * random(0), size * random(1), size * random(2)};
        const Rgb back = decoded(shared_exponent(colour));
        const double brightest = std::max({colour.r, colour.g, colour.b});
        // The mantissa of the brightest channel is at least 256: half of a step is brightest / 512 at most.
        const double step = brightest / 512.0;
        CHECK(std::abs(back.r - std::min(colour.r, largest_shared)) <= step);
        CHECK(std::abs(back.g - std::min(colour.g, largest_shared)) <= step);
        CHECK(std::abs(back.b - std::min(colour.b, largest_shared)) <= step);
    }
}

TEST_CASE("colours with few digits are kept exactly")
{
    for (const Rgb colour : {Rgb{0, 0, 0}, Rgb{1, 0.5, 0.25}, Rgb{511, 1, 256}, Rgb{largest_shared, 0, 128},
                             Rgb{std::exp2(-24), 0, std::exp2(-23)}})
        CHECK(decoded(shared_exponent(colour)) == colour);
}

TEST_CASE("a mantissa that rounds up to ten bits takes the next exponent")
{
    // 511.75 = 1023.5 / 2: with an exponent for numbers below 512 it would need the mantissa 512.
    CHECK(decoded(shared_exponent({511.75, 2, 0})) == Rgb{512, 2, 0});
}

TEST_CASE("what no colour can be is clipped")
{
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(decoded(shared_exponent({-1, infinity, std::nan("")})) == Rgb{0, largest_shared, 0});
    CHECK(shared_exponent({1e-12, 0, 0}) == 0);
}

} // namespace packed_values_test
