#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
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

/// ThreadPool::run on a pool that belongs to the calling thread. Calls can be nested; an inner call by a thread whose
/// pool is busy uses a temporary pool.
void run_on_threads(int threads, const std::function<void()>& work);

} // namespace multipath
