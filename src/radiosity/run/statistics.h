#pragma once

#include "scene/rgb.h"

#include <cmath>
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

/// Mean of successive samples, and sum of their squared deviations from the mean, updated without cancellation (Welford
/// 1962). Value is double, or Rgb for moments of each channel.
template <class Value>
struct Moments
{
    Value mean{};
    Value squares{}; ///< sum of the squared deviations
};

/// The moments after one more sample, which is sample number `count` = 1, 2, ...
template <class Value>
Moments<Value> with_sample(Moments<Value> moments, const Value& sample, double count)
{
    const Value before = sample - moments.mean;
    moments.mean += (1.0 / count) * before;
    moments.squares += before * (sample - moments.mean);
    return moments;
}

/// Standard error of the mean of `count` >= 2 independent samples. `squares`: sum of their squared deviations.
inline double standard_error_of_mean(double squares, double count)
{
    return std::sqrt(1.0 / (count * (count - 1.0)) * squares);
}

/// Mean of independent samples, with its standard error.
class RunningMean
{
public:
    void add(double sample) { moments_ = with_sample(moments_, sample, ++count_); }
    double mean() const { return moments_.mean; } ///< 0 without samples
    /// Needs two samples or more.
    double standard_error() const { return standard_error_of_mean(moments_.squares, count_); }

private:
    Moments<double> moments_;
    double count_ = 0.0;
};

/// P(|T| > t), the probability of both tails of Student's distribution with `degrees` >= 1 degrees of freedom, for
/// t >= 0 (Abramowitz and Stegun, 26.7.3 and 26.7.4).
double student_tail(double t, int degrees);

/// The t for which student_tail(t, degrees) is `tail`, 0 < tail < 1.
double student_quantile(double tail, int degrees);

} // namespace multipath
