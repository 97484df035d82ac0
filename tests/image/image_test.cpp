#include "image/image.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace pixmap_test {

using namespace multipath;

TEST_CASE("a picture of 2 x 1 pixels is these bytes of PPM")
{
    const ScreenImage image{2, 1, {255, 0, 10, 1, 2, 3}};
    CHECK(ppm_bytes(image) == std::string("P6\n2 1\n255\n\xff\x00\x0a\x01\x02\x03", 17));
}

// A line end inside the comment would be read as the width.
TEST_CASE("a comment of several lines stays one comment line")
{
    const ScreenImage image{1, 1, {1, 2, 3}};
    CHECK(ppm_bytes(image, "room.obj\n640 480\r") == "P6\n# room.obj 640 480 \n1 1\n255\n\x01\x02\x03");
}

// IEEE 754: 1 = 3f800000, 0.5 = 3f000000, -2 = c0000000, 0 = 00000000; low byte first, the bottom row first.
TEST_CASE("a picture of 1 x 2 pixels is these bytes of PFM")
{
    const Image image{1, 2, {{1.0, 0.5, 0.0}, {-2.0, 0.0, 1.0}}};
    const std::string bottom("\x00\x00\x00\xc0\x00\x00\x00\x00\x00\x00\x80\x3f", 12);
    const std::string top("\x00\x00\x80\x3f\x00\x00\x00\x3f\x00\x00\x00\x00", 12);
    CHECK(pfm_bytes(image) == "PF\n1 2\n-1.0\n" + bottom + top);
}

// The exponent of the largest channel serves all: 1 = 128 / 256 * 2^1, 3 = 192 / 256 * 2^2. Beyond the range of numbers
// the format has no light or its brightest one.
TEST_CASE("a picture of 2 x 2 pixels is these bytes of Radiance RGBE")
{
    const Image image{2, 2, {{1.0, 0.5, 0.25}, {3.0, 0.0, -1.0}, {0.0, 0.0, 0.0}, {1e-50, 0.0, 0.0}}};
    const std::string pixels("\x80\x40\x20\x81\xc0\x00\x00\x82\x00\x00\x00\x00\x00\x00\x00\x00", 16);
    CHECK(hdr_bytes(image, "a\nb") ==
          "#?RADIANCE\n# a?b\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=3.14159265\n\n-Y 2 +X 2\n" + pixels);
}

// IEEE 754 binary16: known numbers, the ends of the ranges, ties to even, and what is too large.
TEST_CASE("the channels of an OpenEXR picture are the nearest half floats")
{
    const std::vector<std::pair<double, int>> known = {
        {0.0, 0x0000},     {1.0, 0x3c00},       {0.5, 0x3800},         {-2.0, 0xc000},          {1.0 / 3.0, 0x3555},
        {65504.0, 0x7bff}, {65519.0, 0x7bff},   {1e9, 0x7bff},         {0x1p-14, 0x0400},       {0x1p-24, 0x0001},
        {0x1p-25, 0x0000}, {0x1.8p-24, 0x0002}, {0x1.ff8p-15, 0x03ff}, {1.0 + 0x1p-11, 0x3c00}, {1.0 + 0x3p-11, 0x3c02},
        {2047.75, 0x6800}, {1e-30, 0x0000},     {-1e9, 0xfbff}};
    for (const auto& [number, bits] : known) {
        const double value = number;
        const std::string bytes = exr_bytes({1, 1, {{0.0, 0.0, value}}});
        const std::string row = bytes.substr(bytes.size() - 6); // blue, green, red
        CAPTURE(value);
        CHECK(static_cast<unsigned char>(row[0]) + 256 * static_cast<unsigned char>(row[1]) == bits);
        CHECK(row.substr(2) == std::string(4, '\0'));
    }
    for (int bits = 0; bits < 0x7c00; ++bits) { // every half float is itself
        const int exponent = bits >> 10;
        const double value = std::ldexp((exponent > 0 ? 1024 : 0) + bits % 1024, std::max(exponent, 1) - 25);
        const std::string bytes = exr_bytes({1, 1, {{value, 0.0, 0.0}}});
        const auto low = static_cast<unsigned char>(bytes[bytes.size() - 2]);
        const auto high = static_cast<unsigned char>(bytes[bytes.size() - 1]);
        if (low + 256 * high != bits)
            FAIL(bits);
    }
}

} // namespace pixmap_test
