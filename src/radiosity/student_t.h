#pragma once

namespace multipath {

/// The probability that a Student's t of so many degrees of freedom (at least 1) is farther from zero than t >= 0.
/// Abramowitz and Stegun, 26.7.3 and 26.7.4.
double student_tail(double t, int degrees);

/// The t with this tail, 0 < tail < 1.
double student_quantile(double tail, int degrees);

} // namespace multipath
