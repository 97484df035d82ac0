#pragma once

#include <cmath>
#include <vector>

namespace multipath {

/// Mean of independent results, and the standard error of that mean.
struct Estimate
{
    double mean = 0.0;
    double standard_error = 0.0;

    /// Is the expected value within k standard errors?
    bool agrees_with(double expected, double k = 4.0) const { return std::abs(mean - expected) <= k * standard_error; }
};

inline Estimate estimate(const std::vector<double>& samples)
{
    const auto n = static_cast<double>(samples.size());
    double sum = 0.0;
    for (const double x : samples)
        sum += x;
    const double mean = sum / n;
    double squares = 0.0;
    for (const double x : samples)
        squares += (x - mean) * (x - mean);
    return {mean, std::sqrt(squares / (n - 1.0) / n)};
}

} // namespace multipath
