#pragma once

#include "base/memory.h"
#include "parallel/run_control.h"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace multipath {

/// Worker threads that are reused from task to task, because starting a thread takes as long as some tasks. A pool does
/// one task at a time.
class ThreadPool
{
public:
    ThreadPool() = default;
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool();

    /// Runs `work` on up to `threads` threads at once, of which the calling thread is always one, and waits for all of
    /// them. There may be fewer: the system may grant fewer threads, and workers that wake up after the caller has
    /// finished do not run `work`. A fast worker may run `work` more than once. So `work` must drain a queue that the
    /// threads share. `work` must not throw.
    void run(int threads, const std::function<void()>& work);

private:
    void add_workers(std::size_t count);
    void worker_loop();

    std::vector<std::thread> workers_;
    std::mutex mutex_; ///< guards all members below
    std::condition_variable wake_;
    std::condition_variable idle_;
    const std::function<void()>* work_ = nullptr;
    int open_slots_ = 0; ///< workers that may still join the current work
    int working_ = 0;    ///< workers that run the current work
    bool stopping_ = false;
};

/// ThreadPool::run on the pool of the program. A call while it is busy, from within the work or by another thread, uses
/// a temporary pool. (No pool of each thread: Windows lets no thread end while it joins others.)
void run_on_threads(int threads, const std::function<void()>& work);

/// Division of the numbers 0 ... items - 1, which stand for lines, rays or other units of work, into blocks.
struct Blocks
{
    std::uint64_t items; ///< total number of items
    std::uint64_t size;  ///< items per block, above zero; the last block may have fewer

    std::uint64_t count() const { return (items + size - 1) / size; }
    /// Index of the first item of a block, and so the number of items in all earlier blocks.
    std::uint64_t first(std::uint64_t block) const { return std::min(items, block * size); }
    /// Number of items in a block.
    std::size_t length(std::uint64_t block) const { return static_cast<std::size_t>(first(block + 1) - first(block)); }
};

/// Runs work(block) once for each block 0 ... block_count - 1 on up to `threads` threads, in any order. The calling
/// thread is one of them; `threads` below 1 counts as 1. If a block throws, no further blocks are started, and the
/// first exception is rethrown after all threads have stopped.
void parallel_blocks(std::uint64_t block_count, int threads, const std::function<void(std::uint64_t block)>& work);

/// Like parallel_blocks for the numbers 0 ... count - 1 in ranges of range_size (the last may be shorter): work(first,
/// end) handles the numbers first ... end - 1.
void parallel_ranges(std::uint32_t count, std::uint32_t range_size, int threads,
                     const std::function<void(std::uint32_t first, std::uint32_t end)>& work);

constexpr std::uint32_t numbers_at_a_time = 1024; ///< range size of parallel_numbers and parallel_sum

/// Runs work(i) for i = 0 ... count - 1 in parallel, in any order. Exceptions as in parallel_blocks.
template <class Work>
void parallel_numbers(std::uint32_t count, int threads, const Work& work)
{
    parallel_ranges(count, numbers_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i)
            work(i);
    });
}

/// Sum of term(i) for i = 0 ... count - 1, computed in parallel, with the same bits for any number of threads.
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

/// The list of value(i) for i = 0 ... count - 1, computed in parallel.
template <class Make>
auto parallel_list(std::uint32_t count, int threads, const Make& value)
{
    auto list = large_vector<std::decay_t<decltype(value(count))>>(count);
    parallel_numbers(count, threads, [&](std::uint32_t i) { list[i] = value(i); });
    return list;
}

/// Runs produce(block, slot) once for each block 0 ... block_count - 1 on up to `threads` threads, and then
/// consume(block, slot) one block at a time, in ascending order, while later blocks are being produced. `slot` (0 ...
/// slot_count(threads) - 1) identifies the buffer that belongs to the block until the block is consumed. With one
/// thread, everything runs on the calling thread. Exceptions as in parallel_blocks.
using BlockWork = std::function<void(std::uint64_t block, int slot)>;
void ordered_blocks(std::uint64_t block_count, int threads, const BlockWork& produce, const BlockWork& consume);

/// Like ordered_blocks for the blocks `next` ... `end` - 1. Whenever the checkpoint wants a pause, the blocks in
/// progress are finished, `next` is set to the first block that is not done, and Checkpoint::pause() is called. At this
/// time `next` and the results of the blocks are consistent; a Checkpoint::Part of the caller must save both. On return
/// `next` = `end`, or `next` < `end` if the checkpoint has stopped the work before the last block. Calls the line
/// counter with 0 lines at the start if there are blocks to do.
void resumable_blocks(std::uint64_t& next, std::uint64_t end, const RunControl& run, const BlockWork& produce,
                      const BlockWork& consume);

/// Number of slots, each with a buffer, that ordered_blocks uses with this number of threads.
int slot_count(int threads);

/// The units of work (blocks or rows of a stage) that one shard does, and the progress of the shard. See Shard in
/// run_control.h.
struct ShardRange
{
    std::uint64_t all = 0;   ///< number of units of all shards together
    std::uint64_t first = 0; ///< this shard does the units first ... end - 1
    std::uint64_t next = 0;  ///< the units first ... next - 1 are done
    std::uint64_t end = 0;
    std::uint64_t shard_count = 1; ///< number of shards; 1 in the result of union_of

    /// The part of `all` units that this shard does; nothing is done yet.
    static ShardRange of(std::uint64_t all, Shard shard)
    {
        return {all, shard.begin(all), shard.begin(all), shard.end(all), shard.of};
    }
    /// True if there is more than one shard. Even then one of the shards may have all units, if there are few.
    bool is_shard() const { return shard_count > 1; }

    /// Saves or restores the range. Throws ArchiveError for a range that no shard can have.
    void visit(Archive& archive);
};

/// The union of the ranges of one or more shards, given in any order. Throws ArchiveError unless each range is finished
/// and the ranges together cover all units exactly once.
ShardRange union_of(std::vector<ShardRange> ranges);

/// Like resumable_blocks for the units of `range`, in a stage whose results can be added to those of other shards. If
/// there are several shards, run.checkpoint must not be null: when the units are done, Checkpoint::publish_shard saves
/// the results and stops the run.
void shard_blocks(ShardRange& range, const RunControl& run, const BlockWork& produce, const BlockWork& consume);

/// One buffer for each slot of ordered_blocks, resumable_blocks or shard_blocks.
template <class Buffer>
class BlockBuffers
{
public:
    /// All buffers start as copies of `empty`.
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
