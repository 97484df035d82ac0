#include "image/huffman.h"

#include "sampling/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <queue>

namespace huffman_test {

using namespace multipath;

namespace {

std::uint64_t total_bits(const std::vector<std::uint32_t>& frequencies, const std::vector<std::uint8_t>& lengths)
{
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < frequencies.size(); ++i)
        bits += std::uint64_t{frequencies[i]} * lengths[i];
    return bits;
}

/// Huffman's own algorithm: the cost of the best code without a limit is the sum of all inner nodes.
std::uint64_t huffman_bits(const std::vector<std::uint32_t>& frequencies)
{
    std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<std::uint64_t>> nodes(
        frequencies.begin(), frequencies.end());
    std::uint64_t bits = 0;
    while (nodes.size() > 1) {
        const std::uint64_t first = nodes.top();
        nodes.pop();
        const std::uint64_t sum = first + nodes.top();
        nodes.pop();
        nodes.push(sum);
        bits += sum;
    }
    return bits;
}

/// The sum of 2^(15 - length) over the code words: 2^15 for a complete prefix code (Kraft).
std::uint32_t kraft_sum(const std::vector<std::uint8_t>& lengths)
{
    std::uint32_t sum = 0;
    for (const std::uint8_t length : lengths)
        sum += length > 0 ? 1u << (15 - length) : 0u;
    return sum;
}

const std::vector<std::uint32_t> fibonacci = {1,  1,   2,   3,   5,   8,   13,   21,   34,   55,
                                              89, 144, 233, 377, 610, 987, 1597, 2584, 4181, 6765};

} // namespace

TEST_CASE("a code under a limit that does not bind costs what Huffman's algorithm says")
{
    std::vector<std::uint32_t> frequencies;
    for (std::uint64_t i = 0; i < 286; ++i)
        frequencies.push_back(1 + static_cast<std::uint32_t>(random_bits(1, i) % 1000));
    const std::vector<std::uint8_t> lengths = code_lengths(frequencies, 15);
    CHECK(total_bits(frequencies, lengths) == huffman_bits(frequencies));
    CHECK(kraft_sum(lengths) == 1u << 15);
}

// Fibonacci frequencies make the deepest tree: 19 levels for 20 symbols without a limit.
TEST_CASE("no code word is longer than the limit, and the code stays complete")
{
    for (const std::size_t limit : {5u, 7u, 15u}) {
        const std::vector<std::uint8_t> lengths = code_lengths(fibonacci, limit);
        CHECK(*std::max_element(lengths.begin(), lengths.end()) == limit);
        CHECK(kraft_sum(lengths) == 1u << 15);
    }
}

// Brute force: with 4 symbols in at most 2 bits the only complete codes are 2,2,2,2; with 5 in at most 3 bits the best
// of all assignments is found by trying every one.
TEST_CASE("the cost under a binding limit is the least of all prefix codes")
{
    const std::vector<std::uint32_t> frequencies = {1, 2, 4, 8, 16};
    std::uint64_t best = ~std::uint64_t{0};
    std::vector<std::uint8_t> lengths(5, 1);
    for (int number = 0; number < 243; ++number) {
        int rest = number;
        for (std::uint8_t& length : lengths) {
            length = static_cast<std::uint8_t>(1 + rest % 3);
            rest /= 3;
        }
        if (kraft_sum(lengths) <= 1u << 15)
            best = std::min(best, total_bits(frequencies, lengths));
    }
    CHECK(total_bits(frequencies, code_lengths(frequencies, 3)) == best);
    CHECK(best > huffman_bits(frequencies));
}

TEST_CASE("one symbol alone gets a companion, unused ones get nothing")
{
    CHECK(code_lengths({0, 0, 7, 0}, 15) == std::vector<std::uint8_t>{1, 0, 1, 0});
    CHECK(code_lengths({0, 0, 0}, 15) == std::vector<std::uint8_t>{1, 1, 0});
    CHECK(code_lengths({5, 0, 7}, 15) == std::vector<std::uint8_t>{1, 0, 1});
}

// The example of RFC 1951, section 3.2.2: A ... H have the words 010 011 100 101 110 00 1110 1111.
TEST_CASE("code words are those of the RFC's example, first bit lowest")
{
    const std::vector<std::uint16_t> expected = {0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111, 0b1111};
    CHECK(code_words({3, 3, 3, 3, 3, 2, 4, 4}) == expected);
}

} // namespace huffman_test
