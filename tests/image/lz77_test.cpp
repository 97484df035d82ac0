#include "image/lz77.h"

#include "sampling/random.h"

#include <doctest/doctest.h>

namespace lz77_test {

using namespace multipath;

namespace {

std::string expanded(const std::vector<Token>& tokens)
{
    std::string bytes;
    for (const Token& token : tokens) {
        if (token.length == 0)
            bytes += static_cast<char>(token.value);
        for (int i = 0; i < token.length; ++i)
            bytes += bytes.at(bytes.size() - token.value);
    }
    return bytes;
}

std::string noise(std::size_t size, std::uint64_t letters)
{
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i)
        bytes += static_cast<char>(random_bits(7, i) % letters);
    return bytes;
}

} // namespace

TEST_CASE("tokens expand to the bytes they were made from")
{
    for (const std::size_t size : {0u, 1u, 2u, 3u, 4u, 1000u, 100000u})
        for (const std::uint64_t letters : {1u, 2u, 5u, 256u}) {
            const std::string bytes = noise(size, letters);
            CHECK(expanded(lz77_tokens(bytes)) == bytes);
        }
}

TEST_CASE("a run of equal bytes is one literal and copies of the greatest length")
{
    const std::vector<Token> tokens = lz77_tokens(std::string(1 + 3 * 258, 'x'));
    REQUIRE(tokens.size() == 4);
    CHECK(tokens[0].length == 0);
    for (std::size_t i = 1; i < 4; ++i) {
        CHECK(tokens[i].length == 258);
        CHECK(tokens[i].value == 1);
    }
}

// The window of deflate is 32768 bytes: a repetition at that distance is found, one byte farther it must not be.
TEST_CASE("copies reach back to the edge of the window and not beyond")
{
    const std::string word = "a phrase that noise does not contain";
    for (const std::size_t distance : {std::size_t{32768}, std::size_t{32769}}) {
        std::string bytes = word + noise(distance - word.size(), 256) + word;
        const std::vector<Token> tokens = lz77_tokens(bytes);
        CHECK(expanded(tokens) == bytes);
        CHECK((tokens.back().length == word.size()) == (distance == 32768));
    }
}

// "abc" then "bcdef": at the second "abc" three bytes match, one place later five do.
TEST_CASE("a copy waits when the next place offers a longer one")
{
    const std::vector<Token> tokens = lz77_tokens("abc.bcdef.abcdef");
    REQUIRE(tokens.size() >= 2);
    CHECK(tokens[tokens.size() - 2].length == 0);
    CHECK(tokens.back().length == 5);
    CHECK(tokens.back().value == 7);
}

} // namespace lz77_test
