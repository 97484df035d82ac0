#include "parallel/blocks.h"

#include "base/errors.h"

#include <atomic>
#include <doctest/doctest.h>
#include <stdexcept>
#include <thread>
#include <vector>

namespace blocks_test {

using namespace multipath;

TEST_CASE("every block is produced once and consumed in order, one at a time")
{
    for (const int threads : {1, 2, 5}) {
        std::vector<std::uint64_t> slots(static_cast<std::size_t>(slot_count(threads)));
        std::vector<std::uint64_t> consumed;
        std::atomic<int> consumers{0};
        ordered_blocks(
            1000, threads,
            [&](std::uint64_t block, int slot) { slots[static_cast<std::size_t>(slot)] = block * block; },
            [&](std::uint64_t block, int slot) {
                CHECK(++consumers == 1);
                CHECK(slots[static_cast<std::size_t>(slot)] == block * block);
                consumed.push_back(block);
                --consumers;
            });
        REQUIRE(consumed.size() == 1000);
        for (std::uint64_t block = 0; block < 1000; ++block)
            CHECK(consumed[block] == block);
    }
}

TEST_CASE("the failure of a block ends the work and reaches the caller")
{
    for (const int threads : {1, 4}) {
        const auto fail_at_50 = [](std::uint64_t block) {
            if (block == 50)
                throw std::runtime_error("block 50");
        };
        CHECK_THROWS_WITH(parallel_blocks(1000, threads, fail_at_50), "block 50");
        CHECK_THROWS_WITH(
            ordered_blocks(
                1000, threads, [](std::uint64_t, int) {}, [&](std::uint64_t block, int) { fail_at_50(block); }),
            "block 50");
    }
}

// The first block waits for the 99 others, which one thread is left to do.
TEST_CASE("a long block does not hold up the others")
{
    std::atomic<int> done{0};
    parallel_blocks(100, 2, [&](std::uint64_t block) {
        while (block == 0 && done < 99)
            std::this_thread::yield();
        ++done;
    });
    CHECK(done == 100);
}

TEST_CASE("no blocks are no work")
{
    parallel_blocks(0, 4, [](std::uint64_t) { FAIL("called"); });
}

TEST_CASE("ranges cover all numbers once, and only the last one is shorter than asked for")
{
    for (const std::uint32_t count : {0u, 1u, 63u, 64u, 65u, 1000u})
        for (const int threads : {1, 3}) {
            std::vector<std::atomic<int>> visits(count);
            parallel_ranges(count, 64, threads, [&](std::uint32_t first, std::uint32_t end) {
                CHECK(first % 64 == 0);
                CHECK((end == count || end == first + 64));
                for (std::uint32_t i = first; i < end; ++i)
                    ++visits[i];
            });
            for (const std::atomic<int>& number : visits)
                CHECK(number == 1);
        }
}

} // namespace blocks_test

namespace thread_pool_test {

using namespace multipath;

TEST_CASE("a pool runs one task after another, each on no more threads than it may have")
{
    ThreadPool pool;
    for (const int threads : {1, 3, 2, 5, 1, 4}) {
        std::atomic<int> left{2000};
        std::atomic<int> done{0};
        std::atomic<int> workers{0};
        pool.run(threads, [&] {
            ++workers;
            while (left-- > 0) {
                ++done;
                std::this_thread::yield();
            }
        });
        CHECK(done == 2000);
        CHECK(workers >= 1);
        CHECK(workers <= threads);
    }
}

// Neither can go on before the other one came.
TEST_CASE("the threads of a pool work at the same time")
{
    ThreadPool pool;
    std::atomic<int> arrived{0};
    pool.run(2, [&] {
        ++arrived;
        while (arrived < 2)
            std::this_thread::yield();
    });
    CHECK(arrived == 2);
}

TEST_CASE("work within work, and works of different threads, do not disturb each other")
{
    std::atomic<int> done{0};
    const auto share = [&](int threads) {
        std::atomic<int> left{100};
        run_on_threads(threads, [&] {
            while (left-- > 0) {
                std::atomic<int> inner{10};
                run_on_threads(2, [&] {
                    while (inner-- > 0)
                        ++done;
                });
            }
        });
    };
    std::thread other([&] { share(2); });
    share(3);
    other.join();
    CHECK(done == 2000);
}

} // namespace thread_pool_test

namespace shard_range_test {

using namespace multipath;

namespace {

constexpr std::uint64_t units = 11;

ShardRange done(std::uint64_t number, std::uint64_t of)
{
    ShardRange range = ShardRange::of(units, {number, of});
    range.next = range.end;
    return range;
}

} // namespace

TEST_CASE("shards that have done all their units make up the whole, in any order")
{
    for (const std::vector<ShardRange>& ranges :
         {std::vector{done(0, 1)}, {done(1, 2), done(0, 2)}, {done(2, 3), done(0, 3), done(1, 3)}}) {
        const ShardRange whole = union_of(ranges);
        CHECK(whole.all == units);
        CHECK(whole.first == 0);
        CHECK(whole.next == units);
        CHECK(whole.end == units);
        CHECK(!whole.is_shard());
    }
}

TEST_CASE("shards do not make up the whole if one is missing, there twice, of other work or not at its end")
{
    const std::vector<ShardRange> all = {done(0, 3), done(1, 3), done(2, 3)};
    for (std::size_t k = 0; k < all.size(); ++k) {
        CAPTURE(k);
        std::vector<ShardRange> ranges = all;
        ranges[k] = all[(k + 1) % 3];
        CHECK_THROWS_AS(union_of(ranges), ArchiveError);
        ranges = all;
        ranges.erase(ranges.begin() + static_cast<std::ptrdiff_t>(k));
        CHECK_THROWS_AS(union_of(ranges), ArchiveError);
        ranges = all;
        ++ranges[k].all;
        CHECK_THROWS_AS(union_of(ranges), ArchiveError);
        ranges = all;
        --ranges[k].next;
        CHECK_THROWS_AS(union_of(ranges), ArchiveError);
    }
}

} // namespace shard_range_test
