#include "image/image.h"

#include <doctest/doctest.h>

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

} // namespace pixmap_test
