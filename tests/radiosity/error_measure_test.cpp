#include "radiosity/error_measure.h"

#include <doctest/doctest.h>

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
