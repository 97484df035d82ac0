#include "base/memory.h"

#include <cstdint>
#include <doctest/doctest.h>
#include <numeric>
#include <vector>

namespace memory_test {

using namespace multipath;

constexpr std::size_t beyond_huge_pages = std::size_t{1} << 20;

// Large enough for pages of 2 MB, with and without an alignment of their own.
TEST_CASE("large vectors of any size and alignment keep what is written")
{
    struct alignas(64) Row
    {
        std::uint64_t number;
    };
    for (const std::size_t count : {std::size_t{1}, std::size_t{100000}, beyond_huge_pages}) {
        LargeVector<std::uint64_t> plain(count);
        CHECK(std::accumulate(plain.begin(), plain.end(), std::uint64_t{0}) == 0);
        std::iota(plain.begin(), plain.end(), std::uint64_t{1});
        UnsetVector<Row> aligned(count / 8 + 1);
        for (std::size_t k = 0; k < aligned.size(); ++k)
            aligned[k].number = k;
        aligned.resize(2 * aligned.size());
        CHECK(reinterpret_cast<std::uintptr_t>(aligned.data()) % 64 == 0);
        CHECK(std::accumulate(plain.begin(), plain.end(), std::uint64_t{0}) == count * (count + 1) / 2);
        CHECK(aligned[count / 8].number == count / 8);
    }
}

// The second vector may get the memory of the first.
TEST_CASE("a zeroed vector is zero, and is copied and moved like any other")
{
    for (const std::size_t count : {std::size_t{1000}, beyond_huge_pages}) {
        ZeroedVector<std::uint64_t>(count).assign(count, 7);
        ZeroedVector<std::uint64_t> numbers(count);
        CHECK(std::accumulate(numbers.begin(), numbers.end(), std::uint64_t{0}) == 0);
        numbers.back() = 3;
        const ZeroedVector<std::uint64_t> copy = numbers;
        const ZeroedVector<std::uint64_t> moved = std::move(numbers);
        CHECK(copy == moved);
        CHECK(moved.back() == 3);
    }
}

TEST_CASE("to ask for huge pages changes nothing that is in memory")
{
    std::vector<std::uint64_t> numbers(beyond_huge_pages, 7);
    ask_for_huge_pages(numbers.data() + 1, (numbers.size() - 1) * sizeof numbers[0]);
    ask_for_huge_pages(numbers.data(), 1);
    ask_for_huge_pages(nullptr, 0);
    CHECK(numbers == std::vector<std::uint64_t>(beyond_huge_pages, 7));
}

} // namespace memory_test
