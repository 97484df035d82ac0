#pragma once

#include "scene/rgb.h"

#include <vector>

namespace multipath {

/// Distance of an estimate of the radiosity from a reference.
struct ErrorMeasure
{
    double mean_square = 0.0; ///< [W^2/m^4] mean square error, weighted by area ((1) in docs/equations.md), mean over
                              ///< the channels
    double relative_mean_square = 0.0; ///< [1] mean_square over the square of the mean radiosity of the reference
};

/// Error of `estimate` [W/m^2] against `reference` [W/m^2]. All lists have one entry per patch; the areas are in m^2.
/// relative_mean_square is not finite if the reference is black.
ErrorMeasure measure_error(const std::vector<double>& areas, const std::vector<Rgb>& estimate,
                           const std::vector<Rgb>& reference);

/// Expected relative mean square error [1] of an estimate [W/m^2] whose patches have these standard errors [W/m^2]: the
/// mean of their squares, weighted by area, over the square of the mean radiosity of the estimate. 0 if the estimate is
/// black.
double expected_relative_square(const std::vector<double>& areas, const std::vector<Rgb>& estimate,
                                const std::vector<Rgb>& standard_error);

} // namespace multipath
