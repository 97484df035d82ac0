#include "viewer/packed_values.h"

#include "viewer/typed_array.h"

#include <cmath>
#include <doctest/doctest.h>

namespace packed_values_test {

using namespace multipath;

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

} // namespace packed_values_test
