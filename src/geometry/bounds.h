#pragma once

#include "geometry/vec3.h"

#include <algorithm>
#include <limits>

namespace multipath {

/// Axis-aligned bounding box [scene units]. A new box is empty, with low > high; include() makes the box grow. Size,
/// centre, diagonal and area have no meaning for an empty box.
struct Bounds
{
    Vec3 low = {infinity, infinity, infinity};
    Vec3 high = {-infinity, -infinity, -infinity};

    static constexpr double infinity = std::numeric_limits<double>::infinity();

    void include(Vec3 p)
    {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    void include(const Bounds& other) ///< `other` must not be empty
    {
        include(other.low);
        include(other.high);
    }
    bool empty() const { return low.x > high.x; }
    Vec3 size() const { return high - low; }
    Vec3 centre() const { return 0.5 * (low + high); }
    double diagonal() const { return length(size()); }
    double largest_coordinate() const ///< absolute value
    {
        return std::max({-low.x, -low.y, -low.z, high.x, high.y, high.z}); // low <= high: the others are not larger
    }
    double area() const ///< sum of the areas of the six sides
    {
        const Vec3 s = size();
        return 2.0 * (s.x * s.y + s.y * s.z + s.z * s.x);
    }
};

/// Significant digits for coordinates in a box: `near` for one near the origin, and more for one so far away that its
/// coordinates agree in the first digits. With 7 or more they are exact to a millionth of the diagonal.
inline int coordinate_digits(const Bounds& box, int near)
{
    constexpr int most = 17; // of a double
    int digits = near;
    for (double size = 1.6 * box.diagonal(); digits < most && box.largest_coordinate() > size; size *= 10.0)
        ++digits;
    return digits;
}

/// True if the boxes have a point in common; boxes that only touch overlap.
inline bool overlap(const Bounds& a, const Bounds& b)
{
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

} // namespace multipath
