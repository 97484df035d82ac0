#include "image/srgb.h"

#include <doctest/doctest.h>

namespace srgb_test {

using namespace multipath;

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

} // namespace srgb_test
