#pragma once

#include "geometry/vec3.h"
#include "scene/scene.h"

namespace multipath {

// A skin: surfaces that a viewer takes for one, such as the triangles of a sphere, and that are shaded as one.

/// A point of a skin in the open, with the unit normal there.
struct OpenPoint
{
    Vec3 point;
    Vec3 normal;
};

/// Do two unit normals belong to one skin, or is there a crease between them?
bool level(Vec3 a, Vec3 b);

/// Does anything stand between two points of one skin, close to each other, such as a wall on a floor? What lies level
/// with one of them does not count.
bool parted(const Scene& scene, const OpenPoint& a, const OpenPoint& b);

} // namespace multipath
