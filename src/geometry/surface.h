#pragma once

#include "base/memory.h"
#include "geometry/bounds.h"
#include "geometry/vec3.h"

namespace multipath {

/// Shape of a Surface.
enum class Shape { parallelogram, triangle };

/// Planar surface of the scene before its subdivision into patches: the points origin + u * edge_u + v * edge_v with
/// 0 <= u, v <= 1 (and u + v <= 1 for a triangle). The front of the surface is the side from which the turn from edge_u
/// to edge_v is counter-clockwise.
struct Surface
{
    Shape shape = Shape::parallelogram;
    Vec3 origin;
    Vec3 edge_u;
    Vec3 edge_v;

    Vec3 at(double u, double v) const { return origin + u * edge_u + v * edge_v; }
    /// Unit normal on the front side; the area must not be zero.
    Vec3 normal() const { return normalized(cross(edge_u, edge_v)); }
    /// Area [square of the scene unit].
    double area() const { return (shape == Shape::triangle ? 0.5 : 1.0) * length(cross(edge_u, edge_v)); }
    /// Centroid.
    Vec3 centre() const { return shape == Shape::triangle ? at(1.0 / 3.0, 1.0 / 3.0) : at(0.5, 0.5); }
    Bounds bounds() const
    {
        Bounds box;
        box.include(origin);
        box.include(origin + edge_u);
        box.include(origin + edge_v);
        if (shape == Shape::parallelogram)
            box.include(at(1.0, 1.0));
        return box;
    }
};

inline bool operator==(const Surface& a, const Surface& b)
{
    return a.shape == b.shape && a.origin == b.origin && a.edge_u == b.edge_u && a.edge_v == b.edge_v;
}

/// The surfaces of a scene, up to millions of them. A surface is identified by its index in this list.
using SurfaceList = LargeVector<Surface>;

} // namespace multipath
