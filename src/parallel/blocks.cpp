#include "parallel/blocks.h"

#include "base/errors.h"
#include "parallel/thread_memory.h"

#include <atomic>
#include <exception>
#include <system_error>
#include <tuple>

namespace multipath {

// The caller of ThreadPool::run() opens as many slots as workers may join, wakes the workers and works itself. A worker
// that wakes up takes a slot and runs the work. When the caller has finished, it closes the slots that are left and
// waits for the workers that are still busy.

ThreadPool::~ThreadPool()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    for (std::thread& worker : workers_)
        worker.join();
}

void ThreadPool::run(int threads, const std::function<void()>& work)
{
    if (threads > 1)
        add_workers(static_cast<std::size_t>(threads) - 1);
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        work_ = &work;
        open_slots_ = std::min(threads - 1, static_cast<int>(workers_.size()));
    }
    wake_.notify_all();
    work();
    std::unique_lock<std::mutex> lock(mutex_);
    open_slots_ = 0;
    idle_.wait(lock, [this] { return working_ == 0; });
}

void ThreadPool::add_workers(std::size_t count)
{
    workers_.reserve(count); // so that only the start of a thread can fail below, nothing after it
    try {
        while (workers_.size() < count)
            workers_.emplace_back([this] {
                worker_loop();
                release_thread_memory();
            });
    } catch (const std::system_error&) {
        // The system grants no more threads; the existing ones do all the work.
    }
}

void ThreadPool::worker_loop()
{
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
        wake_.wait(lock, [this] { return open_slots_ > 0 || stopping_; });
        if (stopping_)
            return;
        --open_slots_;
        ++working_;
        const std::function<void()>& work = *work_;
        lock.unlock();
        work();
        lock.lock();
        if (--working_ == 0)
            idle_.notify_one();
    }
}

void run_on_threads(int threads, const std::function<void()>& work)
{
    if (threads <= 1) {
        work();
        return;
    }
    static ThreadPool pool;
    static std::atomic_flag is_busy = ATOMIC_FLAG_INIT;
    if (is_busy.test_and_set()) { // nested call, or one of another thread
        ThreadPool().run(threads, work);
        return;
    }
    pool.run(threads, work);
    is_busy.clear();
}

// Parallel loops over blocks. parallel_blocks hands out block numbers from a counter. ordered_blocks is a producer-
// consumer pipeline: all threads produce blocks, and one thread at a time consumes the next block in order, once this
// block is produced. At most slot_count(threads) blocks are between start and consumption, so their buffers form a
// ring. A pause lowers the end of the run to the blocks already started.

namespace {

using PauseWish = std::function<bool()>;

/// The state that the threads of one ordered_blocks call share.
class OrderedRun
{
public:
    OrderedRun(std::uint64_t first, std::uint64_t end, int slots, const BlockWork& produce, const BlockWork& consume,
               const PauseWish& wants_pause)
        : first_(first),
          slots_(static_cast<std::uint64_t>(slots)),
          produce_(produce),
          consume_(consume),
          wants_pause_(wants_pause),
          end_(end),
          is_produced_(slots_),
          started_(first),
          consumed_(first)
    {
    }

    /// Loop of each thread: consumes, produces or waits until all blocks are consumed or one has failed. The thread
    /// that consumed last is preferred as the consumer; another one consumes the first block, or if it has nothing to
    /// produce.
    void work()
    {
        std::unique_lock<std::mutex> lock(mutex_);
        try {
            while (!failure_ && consumed_ < end_) {
                const bool ready = !consuming_ && is_produced_[slot_of(consumed_)];
                const bool has_work = started_ < end_ && started_ < consumed_ + slots_;
                if (ready && (consumer_ == std::this_thread::get_id() || consumed_ == first_ || !has_work))
                    consume_next(lock);
                else if (started_ > first_ && started_ < end_ && wants_pause_())
                    end_ = started_;
                else if (has_work)
                    produce_next(lock);
                else
                    changed_.wait(lock);
            }
        } catch (...) {
            if (!lock.owns_lock())
                lock.lock();
            if (!failure_)
                failure_ = std::current_exception();
        }
        changed_.notify_all();
    }

    /// Returns the first block that was not done, or rethrows the failure of a block.
    std::uint64_t next() const
    {
        if (failure_)
            std::rethrow_exception(failure_);
        return consumed_;
    }

private:
    std::size_t slot_of(std::uint64_t block) const { return static_cast<std::size_t>(block % slots_); }

    void consume_next(std::unique_lock<std::mutex>& lock)
    {
        consuming_ = true;
        consumer_ = std::this_thread::get_id();
        const std::uint64_t block = consumed_;
        lock.unlock();
        consume_(block, static_cast<int>(slot_of(block)));
        lock.lock();
        is_produced_[slot_of(block)] = false;
        ++consumed_;
        consuming_ = false;
        changed_.notify_all();
    }

    void produce_next(std::unique_lock<std::mutex>& lock)
    {
        const std::uint64_t block = started_++;
        lock.unlock();
        produce_(block, static_cast<int>(slot_of(block)));
        lock.lock();
        is_produced_[slot_of(block)] = true;
        changed_.notify_all();
    }

    const std::uint64_t first_;
    const std::uint64_t slots_;
    const BlockWork& produce_;
    const BlockWork& consume_;
    const PauseWish& wants_pause_;

    std::mutex mutex_; ///< guards all members below
    std::condition_variable changed_;
    std::uint64_t end_;             ///< lowered to started_ when a pause is wanted
    std::vector<bool> is_produced_; ///< by slot, of the block that was started and not yet consumed
    std::thread::id consumer_;      ///< thread of the last block: its caches contain the data that consuming changes
    std::uint64_t started_;
    std::uint64_t consumed_;
    bool consuming_ = false;
    std::exception_ptr failure_;
};

/// Runs the blocks first ... end - 1, or fewer if a pause is wanted, but at least one. Returns the first block not
/// done.
std::uint64_t run_blocks(std::uint64_t first, std::uint64_t end, int threads, const BlockWork& produce,
                         const BlockWork& consume, const PauseWish& wants_pause)
{
    OrderedRun run(first, end, slot_count(threads), produce, consume, wants_pause);
    run_on_threads(threads, [&] { run.work(); });
    return run.next();
}

} // namespace

int slot_count(int threads)
{
    return threads <= 1 ? 1 : 4 * threads;
}

void ordered_blocks(std::uint64_t block_count, int threads, const BlockWork& produce, const BlockWork& consume)
{
    run_blocks(0, block_count, threads, produce, consume, [] { return false; });
}

void resumable_blocks(std::uint64_t& next, std::uint64_t end, const RunControl& run, const BlockWork& produce,
                      const BlockWork& consume)
{
    const PauseWish wants_pause = [&] { return run.checkpoint && run.checkpoint->wants_pause(); };
    if (next < end)
        run.count_lines(0);
    while (next < end && !run.stopped()) {
        next = run_blocks(next, end, run.threads, produce, consume, wants_pause);
        if (wants_pause())
            run.checkpoint->pause();
    }
}

void parallel_blocks(std::uint64_t block_count, int threads, const std::function<void(std::uint64_t block)>& work)
{
    const auto used = std::min<std::uint64_t>(block_count, static_cast<std::uint64_t>(std::max(threads, 1)));
    std::mutex mutex; // not an atomic counter: some processors of 32 bits have none of 64 bits
    std::uint64_t next = 0;
    std::exception_ptr failure;
    const auto next_block = [&] {
        const std::lock_guard<std::mutex> lock(mutex);
        return next < block_count ? next++ : block_count;
    };
    run_on_threads(static_cast<int>(used), [&] {
        try {
            for (std::uint64_t block = next_block(); block < block_count; block = next_block())
                work(block);
        } catch (...) {
            const std::lock_guard<std::mutex> lock(mutex);
            next = block_count;
            if (!failure)
                failure = std::current_exception();
        }
    });
    if (failure)
        std::rethrow_exception(failure);
}

void parallel_ranges(std::uint32_t count, std::uint32_t range_size, int threads,
                     const std::function<void(std::uint32_t first, std::uint32_t end)>& work)
{
    const Blocks ranges = {count, range_size};
    parallel_blocks(ranges.count(), threads, [&](std::uint64_t range) {
        work(static_cast<std::uint32_t>(ranges.first(range)), static_cast<std::uint32_t>(ranges.first(range + 1)));
    });
}

void ShardRange::visit(Archive& archive)
{
    archive.value<std::uint64_t>("pieces of all", all);
    archive.value<std::uint64_t>("first piece", first);
    archive.value<std::uint64_t>("next piece", next);
    archive.value<std::uint64_t>("end piece", end);
    archive.value<std::uint64_t>("shares", shard_count);
    if (first > next || next > end || end > all)
        throw ArchiveError("the state is damaged: no such pieces of work");
}

ShardRange union_of(std::vector<ShardRange> ranges)
{
    std::sort(ranges.begin(), ranges.end(), [](const ShardRange& a, const ShardRange& b) {
        return std::tie(a.first, a.end) < std::tie(b.first, b.end);
    });
    std::uint64_t done = 0;
    for (const ShardRange& range : ranges) {
        if (range.first != done || range.next != range.end || range.all != ranges[0].all)
            throw ArchiveError("the shards do not fit together; expected all shards of one run, each of them finished");
        done = range.end;
    }
    if (done != ranges[0].all)
        throw ArchiveError("some shards are missing; expected all shards of the run");
    return {done, 0, done, done, 1};
}

void shard_blocks(ShardRange& range, const RunControl& run, const BlockWork& produce, const BlockWork& consume)
{
    resumable_blocks(range.next, range.end, run, produce, consume);
    if (range.is_shard() && !run.stopped())
        run.checkpoint->publish_shard();
}

} // namespace multipath
