#pragma once

#include "geometry/line.h"
#include "geometry/surface.h"
#include "geometry/vec3.h"
#include "parallel/memory.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// Convex hull of a set of points, accurate to about 1e-7 of their extent; of a nearly flat set, to about 1e-7 of its
/// thickness across. The area of a flat set counts both of its sides, as in integral geometry; collinear points have
/// area 0. Construction takes O(n log n) time.
class ConvexHull
{
public:
    explicit ConvexHull(const LargeVector<Vec3>& points);

    double area() const { return area_; }                    ///< surface area [square of the points' unit]
    std::size_t side_count() const { return sides_.size(); } ///< number of triangles; 0 for a flat hull
    /// True if the line, extended without end both ways, meets the hull. Always false for a flat hull.
    bool meets(const Line& line) const;
    /// True if the point lies inside the hull or on its sides. Always false for a flat hull.
    bool holds(Vec3 point) const;
    /// True if the plane of one side has all points on its outer side, or at most `overlap` [scene units] inside. Then
    /// the convex hull of the points reaches no deeper than `overlap` into this hull. The test is sufficient, not
    /// necessary: disjoint sets may give false. Always false for a flat hull.
    bool is_separated_from(const std::vector<Vec3>& points, double overlap) const;

private:
    struct HalfSpace ///< points p with dot(normal, p) <= offset
    {
        Vec3 normal; ///< outward
        double offset;
    };

    double area_ = 0.0;
    std::vector<HalfSpace> sides_;
};

/// Convex hull of the corners of all surfaces.
ConvexHull hull_of(const SurfaceList& surfaces);

} // namespace multipath
