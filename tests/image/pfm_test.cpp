#include "image/pfm.h"

#include <doctest/doctest.h>

namespace pfm_test {

using namespace multipath;

// IEEE 754: 1 = 3f800000, 0.5 = 3f000000, -2 = c0000000, 0 = 00000000; low byte first, the bottom row first.
TEST_CASE("a picture of 1 x 2 pixels is these bytes of PFM")
{
    const Image image{1, 2, {{1.0, 0.5, 0.0}, {-2.0, 0.0, 1.0}}};
    const std::string bottom("\x00\x00\x00\xc0\x00\x00\x00\x00\x00\x00\x80\x3f", 12);
    const std::string top("\x00\x00\x80\x3f\x00\x00\x00\x3f\x00\x00\x00\x00", 12);
    CHECK(pfm_bytes(image) == "PF\n1 2\n-1.0\n" + bottom + top);
}

} // namespace pfm_test
