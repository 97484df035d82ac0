#include "sampling/shuffled_order.h"

#include <cmath>
#include <doctest/doctest.h>
#include <set>

namespace shuffled_order_test {

using namespace multipath;

TEST_CASE("a shuffled stretch holds the same items, each once, and every block its own")
{
    const auto sequence = make_sequence("sobol", 1);
    constexpr std::uint64_t first = 1000;
    constexpr std::uint64_t count = 2 * ShuffledOrder::block_size + 7; // the last block is a short one
    const ShuffledOrder order(*sequence, first, count);
    std::set<std::uint64_t> seen;
    for (std::uint64_t n = first; n < first + count; ++n) {
        const std::uint64_t item = order.item_at(n);
        CHECK((item - first) / ShuffledOrder::block_size == (n - first) / ShuffledOrder::block_size);
        seen.insert(item);
    }
    CHECK(seen.size() == count);
    CHECK(*seen.begin() == first);
    CHECK(*seen.rbegin() == first + count - 1);
    for (const std::uint64_t n : {std::uint64_t{0}, first - 1, first + count, first + 5 * count})
        CHECK(order.item_at(n) == n);
}

// Of a random order, the distance between the items at successive places has the mean size / 3 and a standard deviation
// of size / sqrt(18); over 4095 of them 4 standard errors are 1.5 % of the size. The order itself has the mean 1. A
// second block must not repeat the first: of 4096 places, one in expectation has the same item, and never ten.
TEST_CASE("successive places hold items as far apart as in a random order, and no two blocks are alike")
{
    const auto sequence = make_sequence("sobol", 1);
    constexpr std::uint64_t size = ShuffledOrder::block_size;
    const ShuffledOrder order(*sequence, 0, 4 * size);
    for (std::uint64_t block = 0; block < 4; ++block) {
        double distances = 0.0;
        int as_before = 0;
        for (std::uint64_t k = 1; k < size; ++k) {
            const auto here = static_cast<double>(order.item_at(block * size + k));
            distances += std::abs(here - static_cast<double>(order.item_at(block * size + k - 1)));
            as_before += order.item_at(block * size + k) == block * size + order.item_at(k) ? 1 : 0;
        }
        CHECK(distances / static_cast<double>(size * (size - 1)) == doctest::Approx(1.0 / 3.0).epsilon(0.045));
        if (block > 0)
            CHECK(as_before < 10);
    }
}

TEST_CASE("a shuffled stretch gives the same items in blocks and one by one")
{
    const auto sequence = make_sequence("halton", 1);
    constexpr std::uint64_t first = 50;
    const ShuffledOrder order(*sequence, first, 10000);
    for (const std::uint64_t from : {std::uint64_t{0}, first, first + ShuffledOrder::block_size, std::uint64_t{9990}}) {
        std::vector<Item> items(200);
        order.generate(from, items);
        for (std::uint64_t k = 0; k < items.size(); ++k)
            CHECK(items[k] == order.item(from + k));
    }
}

} // namespace shuffled_order_test
