#include "parallel/crew.h"

#include <atomic>
#include <doctest/doctest.h>
#include <thread>

namespace crew_test {

using namespace multipath;

TEST_CASE("a crew works through one work after another, with as many threads as each may have")
{
    Crew crew;
    for (const int threads : {1, 3, 2, 5, 1, 4}) {
        std::atomic<int> left{2000};
        std::atomic<int> done{0};
        std::atomic<int> workers{0};
        crew.run(threads, [&] {
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
TEST_CASE("the threads of a crew work at the same time")
{
    Crew crew;
    std::atomic<int> arrived{0};
    crew.run(2, [&] {
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
        run_with_crew(threads, [&] {
            while (left-- > 0) {
                std::atomic<int> inner{10};
                run_with_crew(2, [&] {
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

} // namespace crew_test
