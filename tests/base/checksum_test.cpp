#include "base/checksum.h"

#include <doctest/doctest.h>

#include <string>

namespace checksum_test {

using namespace multipath;

// "check" of CRC-32/ISO-HDLC in the catalogue of parametrised CRC algorithms.
TEST_CASE("the CRC-32 of 123456789 is the published check value")
{
    CHECK(crc32("123456789") == 0xcbf43926u);
    CHECK(crc32("") == 0u);
}

TEST_CASE("an empty PNG end chunk has the CRC that ends every PNG file")
{
    CHECK(crc32("IEND") == 0xae426082u);
}

// Worked example in the Wikipedia article on Adler-32; the empty value is defined by RFC 1950.
TEST_CASE("the Adler-32 of published examples")
{
    CHECK(adler32("Wikipedia") == 0x11e60398u);
    CHECK(adler32("") == 1u);
}

// The definition of RFC 1950: both sums reduced at every byte.
TEST_CASE("Adler-32 stays exact over lengths at which its sums would overflow 32 bits")
{
    const std::string bytes(3'000'000, '\xff');
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    CHECK(adler32(bytes) == (b << 16 | a));
}

} // namespace checksum_test
