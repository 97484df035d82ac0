#pragma once

#include "base/memory.h"
#include "geometry/line.h"
#include "geometry/surface.h"
#include "geometry/vec3.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// Convex hull of a set of points, accurate to about 1e-7 of their extent. The hull of a nearly flat set is accurate,
/// in the direction of its thickness, to about 1e-7 of the thickness. A set is flat if it is no thicker than 1e-7 of
/// its extent: then the area counts both sides of the hull, as in integral geometry. Collinear points have area 0.
/// Construction takes O(n log n) time.
class ConvexHull
{
public:
    explicit ConvexHull(const LargeVector<Vec3>& points);

    double area() const { return area_; }                    ///< surface area [square of the points' unit]
    std::size_t side_count() const { return sides_.size(); } ///< number of triangles; 0 for a flat hull
    /// True if the infinite line through `line` meets the hull; t_max does not count. Always false for a flat hull.
    bool meets(const Line& line) const;
    /// True if, for at least one side, no point lies more than `overlap` [scene units] behind the plane of the side,
    /// towards the inside. Then the convex hull of the points reaches no deeper than `overlap` into this hull. A
    /// negative `overlap` demands a gap. The test is sufficient, not necessary: disjoint sets may give false. Always
    /// false for a flat hull.
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
