#include "parallel/crew.h"

#include <algorithm>
#include <system_error>

namespace multipath {

Crew::~Crew()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    called_.notify_all();
    for (std::thread& member : members_)
        member.join();
}

void Crew::run(int threads, const std::function<void()>& work)
{
    if (threads > 1)
        grow(static_cast<std::size_t>(threads) - 1);
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        work_ = &work;
        places_ = std::min(threads - 1, static_cast<int>(members_.size()));
    }
    called_.notify_all();
    work();
    std::unique_lock<std::mutex> lock(mutex_);
    places_ = 0;
    idle_.wait(lock, [this] { return at_work_ == 0; });
}

void Crew::grow(std::size_t size)
{
    members_.reserve(size); // what runs must be joined, so nothing else may fail
    try {
        while (members_.size() < size)
            members_.emplace_back([this] { serve(); });
    } catch (const std::system_error&) {
        // The system grants no more threads: those that run do all the work.
    }
}

void Crew::serve()
{
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
        called_.wait(lock, [this] { return places_ > 0 || ends_; });
        if (ends_)
            return;
        --places_;
        ++at_work_;
        const std::function<void()>& work = *work_;
        lock.unlock();
        work();
        lock.lock();
        if (--at_work_ == 0)
            idle_.notify_one();
    }
}

void run_with_crew(int threads, const std::function<void()>& work)
{
    if (threads <= 1) {
        work();
        return;
    }
    thread_local Crew crew;
    thread_local bool is_busy = false;
    if (is_busy) { // work within work
        Crew().run(threads, work);
        return;
    }
    is_busy = true;
    crew.run(threads, work);
    is_busy = false;
}

} // namespace multipath
