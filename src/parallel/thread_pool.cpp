// The caller of run() opens as many slots as workers may join, wakes the workers and works itself. A worker that wakes
// up takes a slot and runs the work. When the caller has finished, it closes the slots that are left and waits for the
// workers that are still busy.

#include "parallel/thread_pool.h"

#include <algorithm>
#include <system_error>

namespace multipath {

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
            workers_.emplace_back([this] { worker_loop(); });
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
    thread_local ThreadPool pool;
    thread_local bool is_busy = false;
    if (is_busy) { // nested call
        ThreadPool().run(threads, work);
        return;
    }
    is_busy = true;
    pool.run(threads, work);
    is_busy = false;
}

} // namespace multipath
