#include "commands/solve/accuracy.h"

#include <doctest/doctest.h>

#include <cmath>

namespace accuracy_test {

using namespace multipath;

namespace {

constexpr Round round_of(std::uint64_t lines, double error = 0.1)
{
    return {lines, error};
}

} // namespace

// Rounds of 1, 2 and 4 s: after the second, 3 s are gone, and the third would end after 7 s.
TEST_CASE("rounds end where the next one, twice as long as the last, would exceed the time")
{
    Accuracy accuracy;
    accuracy.seconds = 6.9;
    RoundLimit limit(accuracy, 0);
    CHECK(limit.next_lines(round_of(1000), 1.0) == 2000);
    CHECK(limit.next_lines(round_of(2000), 3.0) == 0);
    accuracy.seconds = 7.1;
    RoundLimit longer(accuracy, 0);
    CHECK(longer.next_lines(round_of(1000), 1.0) == 2000);
    CHECK(longer.next_lines(round_of(2000), 3.0) == 4000);
    CHECK(longer.next_lines(round_of(4000), 7.0) == 0);
}

TEST_CASE("rounds end where the next one, of twice the lines, would exceed the lines")
{
    Accuracy accuracy;
    accuracy.tolerance = 1e-9;
    accuracy.most_lines = 131071;
    CHECK(RoundLimit(accuracy, 0).next_lines(round_of(65536), 1.0) == 0);
    accuracy.most_lines = 131072;
    CHECK(RoundLimit(accuracy, 0).next_lines(round_of(65536), 1.0) == 131072);
}

// A tenth of the square of the noise needs ten times the lines, so 16 times, unless there is no time for more than four
// times or lines for eight.
TEST_CASE("the next round has the lines that the tolerance needs, as far as time and lines allow")
{
    Accuracy accuracy;
    accuracy.tolerance = 0.01;
    CHECK(RoundLimit(accuracy, 0).next_lines(round_of(1000, 0.01 * std::sqrt(3.9)), 1.0) == 4000);
    CHECK(RoundLimit(accuracy, 0).next_lines(round_of(1000, 0.01 * std::sqrt(10.0)), 1.0) == 16000);
    CHECK(RoundLimit(accuracy, 0).next_lines(round_of(1000, 1.0), 1.0) == 16000);
    CHECK(RoundLimit(accuracy, 7000).next_lines(round_of(1000, 0.011), 1.0) == 8000);
    accuracy.most_lines = 15999;
    CHECK(RoundLimit(accuracy, 0).next_lines(round_of(1000, 0.01 * std::sqrt(10.0)), 1.0) == 8000);
    accuracy.seconds = 5.5;
    CHECK(RoundLimit(accuracy, 0).next_lines(round_of(1000, 0.01 * std::sqrt(10.0)), 1.0) == 4000);
}

TEST_CASE("rounds end when the tolerance is reached by as many lines as make the error believable")
{
    Accuracy accuracy;
    accuracy.tolerance = 0.01;
    RoundLimit limit(accuracy, 3000);
    CHECK(limit.next_lines(round_of(1000, 0.001), 1.0) == 4000);
    CHECK(limit.next_lines(round_of(4000, 0.011), 2.0) == 8000);
    CHECK(limit.next_lines(round_of(4000, 0.01), 3.0) == 0);
}

// 3^2 + 4^2 = 5^2. Where the patches leave less than 0.19 of the square, the noise still gets this.
TEST_CASE("the noise gets what the patches leave of the tolerance")
{
    Accuracy accuracy;
    accuracy.tolerance = 0.05;
    CHECK(accuracy.noise_tolerance() == doctest::Approx(0.05));
    accuracy.patch_error = 0.03;
    CHECK(accuracy.noise_tolerance() == doctest::Approx(0.04));
    accuracy.patch_error = 0.2;
    CHECK(accuracy.noise_tolerance() == doctest::Approx(0.05 * std::sqrt(0.19)));
    accuracy.patch_error = accuracy.patch_tolerance();
    CHECK(std::hypot(*accuracy.patch_error, accuracy.noise_tolerance()) == doctest::Approx(0.05));
    RoundLimit limit(accuracy, 0);
    CHECK(limit.next_lines(round_of(1000, 0.022), 1.0) == 2000);
    CHECK(limit.next_lines(round_of(1000, 0.0217), 2.0) == 0);
}

} // namespace accuracy_test
