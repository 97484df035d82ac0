#include "sampling/discrepancy.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// Share of all boxes [0, q) that contain both points.
double boxes_around(const PointSet& points, std::size_t a, std::size_t b)
{
    double share = 1.0;
    for (int d = 0; d < points.dimensions; ++d)
        share *= 1.0 - std::max(points.at(a, d), points.at(b, d));
    return share;
}

} // namespace

// Warnock's formula, the integral over q of the squared local discrepancy, term by term:
// 3^-d - (2^(1-d) / N) sum_n prod_d (1 - x_nd^2) + (1 / N^2) sum_n sum_m prod_d (1 - max(x_nd, x_md)).
double l2_star_discrepancy(const PointSet& points)
{
    const auto count = static_cast<double>(points.size());
    double single = 0.0;
    double pairs = 0.0;
    for (std::size_t n = 0; n < points.size(); ++n) {
        double product = 1.0;
        for (int d = 0; d < points.dimensions; ++d)
            product *= 1.0 - points.at(n, d) * points.at(n, d);
        single += product;

        // Sum row by row: a running sum over all pairs would lose the digits that remain after cancellation.
        double row = 0.0;
        for (std::size_t m = 0; m < n; ++m)
            row += boxes_around(points, n, m);
        pairs += 2.0 * row + boxes_around(points, n, n);
    }
    const double square = elementary::pow(3.0, -points.dimensions) -
                          elementary::pow(2.0, 1 - points.dimensions) * single / count + pairs / (count * count);
    return std::sqrt(std::max(square, 0.0));
}

double random_l2_star_discrepancy(std::size_t count, int dimensions)
{
    return std::sqrt((elementary::pow(2.0, -dimensions) - elementary::pow(3.0, -dimensions)) /
                     static_cast<double>(count));
}

} // namespace multipath
