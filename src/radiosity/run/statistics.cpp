#include "radiosity/run/statistics.h"

#include "base/elementary.h"

#include <cmath>
#include <cstddef>

namespace multipath {

ErrorMeasure measure_error(const std::vector<double>& areas, const std::vector<Rgb>& estimate,
                           const std::vector<Rgb>& reference)
{
    double total_area = 0.0;
    Rgb squares;
    Rgb power;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const Rgb error = estimate[i] - reference[i];
        total_area += areas[i];
        squares += areas[i] * (error * error);
        power += areas[i] * reference[i];
    }
    const double mean_radiosity = mean(power) / total_area;
    ErrorMeasure result;
    result.mean_square = mean(squares) / total_area; // (1)
    result.relative_mean_square = result.mean_square / (mean_radiosity * mean_radiosity);
    return result;
}

double expected_relative_square(const std::vector<double>& areas, const std::vector<Rgb>& estimate,
                                const std::vector<Rgb>& standard_error)
{
    double total_area = 0.0;
    double squares = 0.0;
    double power = 0.0;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        total_area += areas[i];
        squares += areas[i] * mean(standard_error[i] * standard_error[i]);
        power += areas[i] * mean(estimate[i]);
    }
    return power > 0.0 ? squares * total_area / (power * power) : 0.0;
}

double student_tail(double t, int degrees)
{
    const double angle = elementary::atan(t / std::sqrt(static_cast<double>(degrees)));
    const double cosine = elementary::cos(angle);
    const bool odd = degrees % 2 == 1;
    double term = odd ? cosine : 1.0;
    double sum = degrees == 1 ? 0.0 : term;
    for (int k = odd ? 3 : 2; k <= degrees - 2; k += 2) { // powers of the cosine in steps of two
        term *= cosine * cosine * (k - 1.0) / k;
        sum += term;
    }
    const double within = elementary::sin(angle) * sum;
    return 1.0 - (odd ? 2.0 / pi * (angle + within) : within);
}

double student_quantile(double tail, int degrees)
{
    double low = 0.0;
    double high = 1.0;
    while (student_tail(high, degrees) > tail)
        high *= 2.0;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (student_tail(middle, degrees) > tail ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace multipath
