#include "radiosity/run/statistics.h"

#include <cmath>
#include <doctest/doctest.h>
#include <initializer_list>

namespace statistics_test {

using namespace multipath;

// 1, 2, 3, 6: mean 3, squares about it 4 + 1 + 0 + 9 = 14, variance of the mean 14 / 3 / 4.
TEST_CASE("samples give their mean and its standard error, also far from zero")
{
    for (const double offset : {0.0, 1e9}) {
        RunningMean mean;
        for (const double sample : {1.0, 2.0, 3.0, 6.0})
            mean.add(offset + sample);
        CHECK(mean.mean() - offset == doctest::Approx(3.0).epsilon(1e-6));
        CHECK(mean.standard_error() == doctest::Approx(std::sqrt(14.0 / 12.0)).epsilon(1e-6));
    }
}

// Two-sided points as every table prints them.
TEST_CASE("Student's quantiles are those of the tables")
{
    CHECK(student_quantile(0.05, 1) == doctest::Approx(12.706).epsilon(1e-4));
    CHECK(student_quantile(0.05, 2) == doctest::Approx(4.303).epsilon(2e-4));
    CHECK(student_quantile(0.05, 5) == doctest::Approx(2.571).epsilon(2e-4));
    CHECK(student_quantile(0.05, 30) == doctest::Approx(2.042).epsilon(3e-4));
    CHECK(student_quantile(0.05, 100) == doctest::Approx(1.984).epsilon(3e-4));
    CHECK(student_quantile(0.01, 10) == doctest::Approx(3.169).epsilon(2e-4));
    CHECK(student_quantile(0.001, 31) == doctest::Approx(3.633).epsilon(2e-4));
}

// One degree of freedom is Cauchy's distribution, two have a root for their integral.
TEST_CASE("Student's tails have closed forms for one and two degrees of freedom")
{
    for (const double t : {0.0, 0.3, 1.0, 7.0, 1e4}) {
        CHECK(student_tail(t, 1) == doctest::Approx(2.0 / 3.14159265358979323846 * std::atan2(1.0, t)));
        CHECK(student_tail(t, 2) == doctest::Approx(1.0 - t / std::sqrt(t * t + 2.0)));
    }
}

TEST_CASE("with many degrees of freedom Student's tail is the normal one")
{
    for (const double t : {0.5, 2.0, 4.0})
        CHECK(student_tail(t, 100000) == doctest::Approx(std::erfc(t / std::sqrt(2.0))).epsilon(2e-3));
}

TEST_CASE("the quantile has the tail that it was asked for")
{
    for (const int degrees : {1, 2, 15, 31, 511})
        for (const double tail : {0.9, 0.05, 1e-6})
            CHECK(student_tail(student_quantile(tail, degrees), degrees) == doctest::Approx(tail).epsilon(1e-6));
}

} // namespace statistics_test

namespace error_measure_test {

using namespace multipath;

// Areas 1 and 3, errors 2 and 1 in every channel: MSE = (1 * 4 + 3 * 1) / 4; mean radiosity (1 * 8 + 3 * 4) / 4 = 5.
TEST_CASE("the mean square error is weighted by area and made relative by the mean radiosity")
{
    const ErrorMeasure error = measure_error({1, 3}, {{10, 10, 10}, {3, 3, 3}}, {{8, 8, 8}, {4, 4, 4}});
    CHECK(error.mean_square == doctest::Approx(1.75));
    CHECK(error.relative_mean_square == doctest::Approx(1.75 / 25));
}

TEST_CASE("in colour it is the mean over the channels")
{
    const ErrorMeasure error = measure_error({2}, {{3, 1, 1}}, {{0, 1, 1}});
    CHECK(error.mean_square == doctest::Approx(3.0));
}

} // namespace error_measure_test
