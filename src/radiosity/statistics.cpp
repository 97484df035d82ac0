#include "radiosity/statistics.h"

#include "geometry/elementary.h"
#include "geometry/pi.h"

#include <cmath>

namespace multipath {

double student_tail(double t, int degrees)
{
    const double angle = elementary::atan(t / std::sqrt(static_cast<double>(degrees)));
    const double cosine = elementary::cos(angle);
    const bool odd = degrees % 2 == 1;
    double term = odd ? cosine : 1.0;
    double sum = degrees == 1 ? 0.0 : term;
    for (int k = odd ? 3 : 2; k <= degrees - 2; k += 2) { // powers of the cosine in steps of two
        term *= cosine * cosine * (k - 1.0) / k;
        sum += term;
    }
    const double within = elementary::sin(angle) * sum;
    return 1.0 - (odd ? 2.0 / pi * (angle + within) : within);
}

double student_quantile(double tail, int degrees)
{
    double low = 0.0;
    double high = 1.0;
    while (student_tail(high, degrees) > tail)
        high *= 2.0;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (student_tail(middle, degrees) > tail ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace multipath
