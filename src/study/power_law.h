#pragma once

#include <optional>
#include <vector>

namespace multipath {

/// y = factor * x^exponent, the line of a log-log plot (2).
struct PowerLaw
{
    double factor = 0.0;
    double exponent = 0.0;       ///< the slope
    double exponent_error = 0.0; ///< its standard error
    int points = 0;

    double at(double x) const;
};

/// Least squares in the logarithms, all points with equal weight: a mean of squares over a scene has nearly the same
/// relative error at any number of lines. The standard error comes from the scatter about the line, so it also tells
/// when a straight line does not describe the points. Empty for less than three different x; all values must be above
/// 0.
std::optional<PowerLaw> fit_power_law(const std::vector<double>& xs, const std::vector<double>& ys);

/// Half the width of the interval that holds the true exponent with 95 %: Student's t for points - 2 degrees of freedom
/// times the standard error.
double exponent_interval(const PowerLaw& law);

} // namespace multipath
