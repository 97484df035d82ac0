#pragma once

#include "scene/rgb.h"

#include <vector>

namespace multipath {

/// How far an estimate of the radiosity is from a reference.
struct ErrorMeasure
{
    double mean_square = 0.0;          ///< MSE (1), mean over the channels [W^2/m^4]
    double relative_mean_square = 0.0; ///< MSE / (mean radiosity of the reference)^2 [1]
};

/// All three lists have one entry per patch; areas in m^2, radiosities in W/m^2.
ErrorMeasure measure_error(const std::vector<double>& areas, const std::vector<Rgb>& estimate,
                           const std::vector<Rgb>& reference);

/// The relative MSE (1) that an estimate with these standard errors [W/m^2] can be expected to have; 0 for a dark one.
double expected_relative_square(const std::vector<double>& areas, const std::vector<Rgb>& estimate,
                                const std::vector<Rgb>& standard_error);

} // namespace multipath
