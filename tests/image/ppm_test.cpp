#include "image/ppm.h"

#include <doctest/doctest.h>

namespace ppm_test {

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

} // namespace ppm_test
