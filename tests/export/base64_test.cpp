#include "export/base64.h"

#include <doctest/doctest.h>
#include <string>

namespace base64_test {

using namespace multipath;

// The test vectors of RFC 4648, section 10.
TEST_CASE("base64 is that of RFC 4648")
{
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foob") == "Zm9vYg==");
    CHECK(base64("fooba") == "Zm9vYmE=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64(std::string("\xff\xfe\x00", 3)) == "//4A");
}

} // namespace base64_test
