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

} // namespace multipath
