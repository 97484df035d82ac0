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

/// Mean of independent samples with its standard error, updated without cancellation (Welford 1962). Value is double,
/// or Rgb for each channel.
template <class Value>
class MeanOf
{
public:
    void add(const Value& sample)
    {
        count_ += 1.0;
        const Value before = sample - mean_;
        mean_ += (1.0 / count_) * before;
        squares_ += before * (sample - mean_);
    }
    Value mean() const { return mean_; } ///< 0 without samples
    /// Needs two samples or more.
    Value standard_error() const { return square_root(1.0 / (count_ * (count_ - 1.0)) * squares_); }

private:
    double count_ = 0.0;
    Value mean_{};
    Value squares_{}; ///< sum of the squared deviations from the mean
};

using RunningMean = MeanOf<double>;

/// P(|T| > t), the probability of both tails of Student's distribution with `degrees` >= 1 degrees of freedom, for
/// t >= 0 (Abramowitz and Stegun, 26.7.3 and 26.7.4).
double student_tail(double t, int degrees);

/// The t for which student_tail(t, degrees) is `tail`, 0 < tail < 1.
double student_quantile(double tail, int degrees);

} // namespace multipath
