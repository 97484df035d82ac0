#include "parallel/thread_pool.h"

#include <atomic>
#include <doctest/doctest.h>
#include <thread>

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
