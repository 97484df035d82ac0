#include "sampling/discrepancy.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// The supremum lies at the coordinate of a point, for the box that ends just below or just above it.
double star_discrepancy_1d(const PointSet& points)
{
    std::vector<double> x = points.coordinates;
    std::sort(x.begin(), x.end());
    const auto count = static_cast<double>(x.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double below = static_cast<double>(i) / count;
        const double above = static_cast<double>(i + 1) / count;
        largest = std::max({largest, x[i] - below, above - x[i]});
    }
    return largest;
}

/// The extreme boxes end at coordinates of points or at 1 (De Clerck 1986). A sweep from left to right keeps in
/// `heights` the sorted y of the points to the left, which are those that a box up to the next x can contain. Points
/// with equal coordinates add boxes that are not extreme, but none that exceeds the supremum.
double star_discrepancy_2d(const PointSet& points)
{
    std::vector<std::pair<double, double>> by_x;
    for (std::size_t n = 0; n < points.size(); ++n)
        by_x.emplace_back(points.at(n, 0), points.at(n, 1));
    std::sort(by_x.begin(), by_x.end());

    const auto count = static_cast<double>(by_x.size());
    std::vector<double> heights = {0.0, 1.0};
    double largest = 0.0;
    for (std::size_t i = 0; i <= by_x.size(); ++i) {
        const double x = i == 0 ? 0.0 : by_x[i - 1].first;
        const double next_x = i == by_x.size() ? 1.0 : by_x[i].first;
        for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
            const double share = static_cast<double>(k) / count;
            largest = std::max({largest, share - x * heights[k], next_x * heights[k + 1] - share});
        }
        if (i < by_x.size())
            heights.insert(std::upper_bound(heights.begin() + 1, heights.end() - 1, by_x[i].second), by_x[i].second);
    }
    return largest;
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

std::optional<double> star_discrepancy(const PointSet& points)
{
    if (points.dimensions == 1)
        return star_discrepancy_1d(points);
    if (points.dimensions == 2)
        return star_discrepancy_2d(points);
    return std::nullopt;
}

} // namespace multipath
