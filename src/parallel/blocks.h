#pragma once

#include "parallel/run_control.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// Items 0 ... items - 1, cut into blocks.
struct Blocks
{
    std::uint64_t items;
    std::uint64_t size; ///< of each block but the last

    std::uint64_t count() const { return (items + size - 1) / size; }
    /// The first item of a block, which is the number of items in the blocks before it.
    std::uint64_t first(std::uint64_t block) const { return std::min(items, block * size); }
    std::size_t length(std::uint64_t block) const { return static_cast<std::size_t>(first(block + 1) - first(block)); }
};

/// Runs work(block) once for each block 0 ... block_count - 1 on up to `threads` threads, in any order.
/// The first exception that a block throws is thrown here after the other threads have stopped.
void parallel_blocks(std::uint64_t block_count, int threads, const std::function<void(std::uint64_t block)>& work);

/// The same for the numbers 0 ... count - 1, up to range_size successive ones at a time: work(first, end) does
/// first ... end - 1.
void parallel_ranges(std::uint32_t count, std::uint32_t range_size, int threads,
                     const std::function<void(std::uint32_t first, std::uint32_t end)>& work);

constexpr std::uint32_t numbers_at_a_time = 1024;

/// Runs work(i) for i = 0 ... count - 1, in any order.
template <class Work>
void parallel_numbers(std::uint32_t count, int threads, const Work& work)
{
    parallel_ranges(count, numbers_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i)
            work(i);
    });
}

/// The sum of term(i): the same bits for any number of threads.
template <class Value, class Term>
Value parallel_sum(std::uint32_t count, int threads, const Term& term)
{
    std::vector<Value> sums(static_cast<std::size_t>(Blocks{count, numbers_at_a_time}.count()));
    parallel_ranges(count, numbers_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        Value sum{};
        for (std::uint32_t i = first; i < end; ++i)
            sum += term(i);
        sums[first / numbers_at_a_time] = sum;
    });
    Value all{};
    for (const Value& sum : sums)
        all += sum;
    return all;
}

/// Runs produce(block, slot) on up to `threads` threads, and consume(block, slot) one block at a time in order of the
/// block number, while later blocks are being produced. `slot` (0 ... slot_count(threads) - 1) names the buffer that
/// the block may use until it is consumed. With one thread everything runs on the caller, in order.
void ordered_blocks(std::uint64_t block_count, int threads,
                    const std::function<void(std::uint64_t block, int slot)>& produce,
                    const std::function<void(std::uint64_t block, int slot)>& consume);

/// As ordered_blocks, from block `next` on, which goes forward with the work. Whenever the checkpoint wants it, all
/// that was begun is finished and there is a pause, in which `next` and what the blocks changed are whole: a part of
/// the checkpoint must hold them. Stops short of `end` where a pause ends the work. The line counter hears of the
/// beginning, as 0 lines.
void resumable_blocks(std::uint64_t& next, std::uint64_t end, const RunControl& run,
                      const std::function<void(std::uint64_t block, int slot)>& produce,
                      const std::function<void(std::uint64_t block, int slot)>& consume);

/// How many buffers ordered_blocks uses with so many threads.
int slot_count(int threads);

/// Which pieces of work, of all that are shared, a run does, and how far it is.
struct SharedRange
{
    std::uint64_t all = 0; ///< pieces of all shares together
    std::uint64_t first = 0;
    std::uint64_t next = 0; ///< first ... next - 1 are done
    std::uint64_t end = 0;
    std::uint64_t shares = 1; ///< into which the work is cut; 1 also after they were united

    static SharedRange of(std::uint64_t all, Shard shard)
    {
        return {all, shard.begin(all), shard.begin(all), shard.end(all), shard.of};
    }
    /// True if there is more than one shard; one of them may have all pieces, if there are few.
    bool is_shard() const { return shares > 1; }

    void visit(Archive& archive); ///< for a checkpoint; throws ArchiveError for what cannot be
};

/// What several shares have done together, in any order. Throws ArchiveError unless it is everything, once.
SharedRange united(std::vector<SharedRange> ranges);

/// The blocks `range` of a stage whose result is a sum of what they find, as resumable_blocks. If other runs do the
/// rest, this one hands in what it has when it is done, and ends.
void shared_blocks(SharedRange& range, const RunControl& run,
                   const std::function<void(std::uint64_t block, int slot)>& produce,
                   const std::function<void(std::uint64_t block, int slot)>& consume);

/// A buffer for each slot of the three functions above.
template <class Buffer>
class BlockBuffers
{
public:
    /// Copies of `empty`.
    explicit BlockBuffers(int threads, const Buffer& empty = Buffer())
        : buffers_(static_cast<std::size_t>(slot_count(threads)), empty)
    {
    }

    Buffer& operator[](int slot) { return buffers_[static_cast<std::size_t>(slot)]; }
    auto begin() const { return buffers_.begin(); }
    auto end() const { return buffers_.end(); }

private:
    std::vector<Buffer> buffers_;
};

} // namespace multipath
