#include "base/lists.h"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace lists_test {

using namespace multipath;

TEST_CASE("a value is among the elements of a list if one of them equals it")
{
    const std::vector<std::string> names = {"floor", "wall", "wall"};
    CHECK(is_among("floor", names));
    CHECK(is_among(std::string_view("wall"), names));
    CHECK_FALSE(is_among("wal", names));
    CHECK_FALSE(is_among(1, std::vector<int>{}));
    CHECK(is_among('b', "abc"));
}

TEST_CASE("a mapped list keeps the order and the number of elements")
{
    const std::vector<std::string> words = {"a", "", "abc"};
    CHECK(mapped(words, &std::string::size) == std::vector<std::size_t>{1, 0, 3});
    CHECK(mapped(std::array{3, 1}, [](int i) { return i + 0.5; }) == std::vector<double>{3.5, 1.5});
    CHECK(mapped(std::vector<int>{}, [](int i) { return i; }).empty());
}

TEST_CASE("a serial list is made of the numbers from 0 in order")
{
    std::string order;
    const auto squares = serial_list(std::size_t{4}, [&order](std::size_t i) {
        order += std::to_string(i);
        return i * i;
    });
    CHECK(squares == std::vector<std::size_t>{0, 1, 4, 9});
    CHECK(order == "0123");
    CHECK(serial_list(0, [](int i) { return i; }).empty());
}

// 1 + 2^-53 rounds to 1, so the terms added in another order give another sum.
TEST_CASE("a sum over a list adds its terms in order")
{
    const double half_step = 0x1p-53;
    CHECK(sum_over(std::array{1.0, half_step, half_step}, [](double term) { return term; }) == 1);
    CHECK(sum_over(std::array{half_step, half_step, 1.0}, [](double term) { return term; }) > 1);
    CHECK(sum_over(std::vector<std::string>{"ab", "c"}, &std::string::size) == 3);
    CHECK(sum_over(std::vector<double>{}, [](double term) { return term; }) == 0);
}

} // namespace lists_test
