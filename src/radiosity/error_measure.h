#pragma once

#include "scene/rgb.h"

#include <vector>

namespace multipath {

/// Distance of an estimate of the radiosity from a reference.
struct ErrorMeasure
{
    double mean_square = 0.0;          ///< MSE (1), mean over the channels [W^2/m^4]
    double relative_mean_square = 0.0; ///< MSE / (mean radiosity of the reference)^2 [1]
};

/// Error of `estimate` against `reference`. All lists have one entry per patch; areas in m^2, radiosities in W/m^2.
ErrorMeasure measure_error(const std::vector<double>& areas, const std::vector<Rgb>& estimate,
                           const std::vector<Rgb>& reference);

/// Expected relative MSE (1) of an estimate whose patches have these standard errors [W/m^2]. 0 if the estimate is
/// black.
double expected_relative_square(const std::vector<double>& areas, const std::vector<Rgb>& estimate,
                                const std::vector<Rgb>& standard_error);

} // namespace multipath
