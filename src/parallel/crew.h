#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace multipath {

/// Threads that wait from one work to the next: to start them takes as long as some of the works that they share.
class Crew
{
public:
    Crew() = default;
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;
    ~Crew();

    /// Runs `work` on up to `threads` threads at once, the caller among them. When it returns to the caller nothing may
    /// be left to do: threads that did not come in time stay away. The system may grant fewer threads; the caller
    /// always works. `work` must not throw.
    void run(int threads, const std::function<void()>& work);

private:
    void grow(std::size_t size);
    void serve();

    std::vector<std::thread> members_;
    std::mutex mutex_; ///< guards all below
    std::condition_variable called_;
    std::condition_variable idle_;
    const std::function<void()>* work_ = nullptr;
    int places_ = 0; ///< how many members may still come
    int at_work_ = 0;
    bool ends_ = false;
};

/// Runs `work` as Crew does, with threads that the calling thread keeps for it until it ends.
void run_with_crew(int threads, const std::function<void()>& work);

} // namespace multipath
