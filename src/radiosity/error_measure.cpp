#include "radiosity/error_measure.h"

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

} // namespace multipath
