#pragma once

#include <cmath>

namespace multipath {

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
