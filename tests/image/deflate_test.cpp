#include "image/deflate.h"

#include "image/checksum.h"
#include "image/inflate.h"
#include "sampling/random.h"

#include <doctest/doctest.h>

namespace deflate_test {

using namespace multipath;

namespace {

std::string noise(std::size_t size, std::uint64_t letters)
{
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i)
        bytes += static_cast<char>(random_bits(3, i) % letters);
    return bytes;
}

} // namespace

TEST_CASE("an independent inflate gives back what deflate was given")
{
    // Sizes around one block of tokens; alphabets from one letter to incompressible bytes.
    for (const std::size_t size : {0u, 1u, 2u, 3u, 300u, 32767u, 32768u, 32769u, 100000u})
        for (const std::uint64_t letters : {1u, 2u, 20u, 256u}) {
            const std::string bytes = noise(size, letters);
            CHECK(inflate(deflate(bytes)) == bytes);
        }
}

TEST_CASE("every length of copy and every distance code survives")
{
    std::string bytes = noise(40000, 256);
    for (std::size_t length = 3; length <= 259; ++length)
        bytes += bytes.substr(bytes.size() - 1 - (length * length) % 32768, length) + static_cast<char>(length);
    CHECK(inflate(deflate(bytes)) == bytes);
}

// Shannon: 8 equally likely letters need 3 bits each; a compressor cannot do with less.
TEST_CASE("independent letters cost their entropy and not much more")
{
    const std::string bytes = noise(100000, 8);
    const double bits_per_letter = 8.0 * static_cast<double>(deflate(bytes).size()) / 100000.0;
    CHECK(bits_per_letter <
          3.6); // short accidental copies are taken although letters would be cheaper, as in zlib (3.51)
    CHECK(bits_per_letter > 2.99);
}

TEST_CASE("a long run shrinks about a thousandfold")
{
    CHECK(deflate(std::string(1'000'000, 'x')).size() < 1200);
}

TEST_CASE("a zlib stream has a valid header and ends with the Adler-32 of its content")
{
    const std::string bytes = "the room is bright";
    const std::string stream = zlib_bytes(bytes);
    const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(stream[i])); };
    CHECK(byte(0) % 16 == 8);                   // deflate
    CHECK((256 * byte(0) + byte(1)) % 31 == 0); // check bits of RFC 1950
    CHECK(inflate(stream.substr(2, stream.size() - 6)) == bytes);
    const std::size_t end = stream.size();
    CHECK((byte(end - 4) << 24 | byte(end - 3) << 16 | byte(end - 2) << 8 | byte(end - 1)) == adler32(bytes));
}

} // namespace deflate_test
