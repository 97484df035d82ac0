#include "parallel/thread_memory.h"

#include "parallel/blocks.h"

#include <doctest/doctest.h>

#include <atomic>
#include <thread>

namespace thread_memory_test {

using namespace multipath;

namespace {

std::atomic<int> made, destroyed;

struct Counted
{
    Counted() { ++made; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    ~Counted() { ++destroyed; }
    int value = 0;
};

struct OtherPurpose
{
    int value = 0;
};

} // namespace

TEST_CASE("a thread keeps one object of each type, and destroys it at its end")
{
    made = destroyed = 0;
    for (int run = 0; run < 3; ++run)
        std::thread([&] {
            thread_memory<Counted>().value += 5;
            thread_memory<OtherPurpose>().value = 7;
            CHECK(thread_memory<Counted>().value == 5);
            CHECK(&thread_memory<Counted>() == &thread_memory<Counted>());
            release_thread_memory();
        }).join();
    CHECK(made == 3);
    CHECK(destroyed == 3);
}

TEST_CASE("threads of a pool keep objects of their own from one task to the next, and none outlives the pool")
{
    made = destroyed = 0;
    std::thread([] {
        {
            ThreadPool pool;
            for (int task = 0; task < 50; ++task) {
                std::atomic<int> left(8);
                pool.run(4, [&] {
                    while (left-- > 0)
                        ++thread_memory<Counted>().value;
                });
            }
            CHECK(made >= 1);
            CHECK(made <= 4); // three workers and the calling thread
            CHECK(destroyed == 0);
        }
        thread_memory<Counted>();
        CHECK(made - destroyed == 1); // that of the calling thread
        release_thread_memory();
    }).join();
    CHECK(destroyed == made);
}

} // namespace thread_memory_test
