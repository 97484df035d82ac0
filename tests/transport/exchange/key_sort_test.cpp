#include "transport/exchange/count_rows.h"

#include "sampling/random.h"

#include <algorithm>
#include <doctest/doctest.h>

namespace key_sort_test {

using namespace multipath;

TEST_CASE("keys of any width are sorted, few and many")
{
    for (const int bits : {1, 11, 12, 33, 63})
        for (const std::size_t count : {0u, 1u, 300u, 700u, 20000u}) {
            CAPTURE(bits);
            CAPTURE(count);
            std::vector<std::uint64_t> keys;
            for (std::uint64_t k = 0; k < count; ++k)
                keys.push_back(random_bits(17, k) & ((std::uint64_t{1} << bits) - 1));
            std::vector<std::uint64_t> expected = keys;
            std::sort(expected.begin(), expected.end());
            sort_keys(keys, bits);
            CHECK(keys == expected);
        }
}

} // namespace key_sort_test
