#include "parallel/huge_pages.h"

#include <cstdint>
#include <doctest/doctest.h>
#include <new>
#include <numeric>
#include <vector>

namespace huge_pages_test {

using namespace multipath;

// Large enough for pages of 2 MB, with and without an alignment of their own.
TEST_CASE("memory large and small, aligned or not, is all there and keeps what is written")
{
    struct alignas(64) Row
    {
        std::uint64_t number;
    };
    for (const std::size_t count : {std::size_t{1}, std::size_t{100000}, std::size_t{1} << 20}) {
        std::vector<std::uint64_t> plain(count);
        std::iota(plain.begin(), plain.end(), std::uint64_t{1});
        std::vector<Row> aligned(count / 8 + 1);
        for (std::size_t k = 0; k < aligned.size(); ++k)
            aligned[k].number = k;
        CHECK(reinterpret_cast<std::uintptr_t>(aligned.data()) % 64 == 0);
        CHECK(std::accumulate(plain.begin(), plain.end(), std::uint64_t{0}) == count * (count + 1) / 2);
        CHECK(aligned.back().number == count / 8);
    }
}

TEST_CASE("to ask for huge pages changes nothing that is in memory")
{
    std::vector<std::uint64_t> numbers(std::size_t{1} << 20, 7);
    ask_for_huge_pages(numbers.data() + 1, (numbers.size() - 1) * sizeof numbers[0]);
    ask_for_huge_pages(numbers.data(), 1);
    ask_for_huge_pages(nullptr, 0);
    CHECK(numbers == std::vector<std::uint64_t>(std::size_t{1} << 20, 7));
}

} // namespace huge_pages_test
