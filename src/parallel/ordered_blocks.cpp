#include "parallel/ordered_blocks.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace multipath {

namespace {

/// Runs `worker` on `threads` threads, the caller among them, and waits for all.
void run_workers(int threads, const std::function<void()>& worker)
{
    std::vector<std::thread> others;
    try {
        for (int i = 1; i < threads; ++i)
            others.emplace_back(worker);
    } catch (const std::system_error&) {
        // The system grants no more threads: those that run do all the work.
    }
    worker();
    for (std::thread& thread : others)
        thread.join();
}

/// The state that the threads of one ordered_blocks call share.
class OrderedRun
{
public:
    using BlockFunction = std::function<void(std::uint64_t, int)>;

    OrderedRun(std::uint64_t block_count, int slots, const BlockFunction& produce, const BlockFunction& consume)
        : block_count_(block_count),
          slots_(static_cast<std::uint64_t>(slots)),
          produce_(produce),
          consume_(consume),
          produced_(slots_, false)
    {
    }

    void work()
    {
        std::unique_lock<std::mutex> lock(mutex_);
        try {
            while (!failure_ && consumed_ < block_count_) {
                if (!consuming_ && produced_[slot(consumed_)])
                    consume_next(lock);
                else if (started_ < block_count_ && started_ < consumed_ + slots_)
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

    void rethrow_failure() const
    {
        if (failure_)
            std::rethrow_exception(failure_);
    }

private:
    std::size_t slot(std::uint64_t block) const { return static_cast<std::size_t>(block % slots_); }

    void consume_next(std::unique_lock<std::mutex>& lock)
    {
        consuming_ = true;
        const std::uint64_t block = consumed_;
        lock.unlock();
        consume_(block, static_cast<int>(slot(block)));
        lock.lock();
        produced_[slot(block)] = false;
        ++consumed_;
        consuming_ = false;
        changed_.notify_all();
    }

    void produce_next(std::unique_lock<std::mutex>& lock)
    {
        const std::uint64_t block = started_++;
        lock.unlock();
        produce_(block, static_cast<int>(slot(block)));
        lock.lock();
        produced_[slot(block)] = true;
        changed_.notify_all();
    }

    const std::uint64_t block_count_;
    const std::uint64_t slots_;
    const BlockFunction& produce_;
    const BlockFunction& consume_;

    std::mutex mutex_; ///< guards all below
    std::condition_variable changed_;
    std::vector<bool> produced_; ///< per slot: filled and not yet consumed
    std::uint64_t started_ = 0;
    std::uint64_t consumed_ = 0;
    bool consuming_ = false;
    std::exception_ptr failure_;
};

} // namespace

int slot_count(int threads)
{
    return threads <= 1 ? 1 : 4 * threads;
}

void ordered_blocks(std::uint64_t block_count, int threads,
                    const std::function<void(std::uint64_t block, int slot)>& produce,
                    const std::function<void(std::uint64_t block, int slot)>& consume)
{
    if (threads <= 1) {
        for (std::uint64_t block = 0; block < block_count; ++block) {
            produce(block, 0);
            consume(block, 0);
        }
        return;
    }
    OrderedRun run(block_count, slot_count(threads), produce, consume);
    run_workers(threads, [&] { run.work(); });
    run.rethrow_failure();
}

void parallel_blocks(std::uint64_t block_count, int threads, const std::function<void(std::uint64_t block)>& work)
{
    const int used =
        static_cast<int>(std::min<std::uint64_t>(block_count, static_cast<std::uint64_t>(std::max(threads, 1))));
    ordered_blocks(
        block_count, used, [&](std::uint64_t block, int) { work(block); }, [](std::uint64_t, int) {});
}

} // namespace multipath
