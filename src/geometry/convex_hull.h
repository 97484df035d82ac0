#pragma once

#include "geometry/line.h"
#include "geometry/surface.h"
#include "geometry/vec3.h"
#include "parallel/memory.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// The convex hull of points, to about 1e-7 of their extent, and of their thickness if they are all but flat. A flat
/// set counts both of its sides, as integral geometry does; points on one line have no area. In time n log n.
class ConvexHull
{
public:
    explicit ConvexHull(const LargeVector<Vec3>& points);

    double area() const { return area_; }                    ///< [square of the points' unit]
    std::size_t side_count() const { return sides_.size(); } ///< triangles
    /// Does the line, taken without ends, meet the hull? Never true of a flat hull.
    bool meets(const Line& line) const;
    /// Does the point lie in the hull, its sides included? Never true of a flat hull.
    bool holds(Vec3 point) const;
    /// Do all points lie beyond the plane of one side, or at most `overlap` [scene units] before it? Then nothing that
    /// they span reaches farther into the hull. Not every set of points beside a hull is found to be so; never true of
    /// a flat hull.
    bool is_beside(const std::vector<Vec3>& points, double overlap) const;

private:
    struct HalfSpace
    {
        Vec3 normal; ///< outward
        double offset;
    };

    double area_ = 0.0;
    std::vector<HalfSpace> sides_;
};

/// The convex hull of all surfaces.
ConvexHull hull_of(const SurfaceList& surfaces);

} // namespace multipath
