#pragma once

#include "geometry/vec3.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

// Smoothing groups: surfaces that look like one surface, such as the triangles of a sphere, and are shaded as one.

/// An uncovered point of a surface (visible_patches.h) with the unit normal of its side.
struct OpenPoint
{
    Vec3 point;
    Vec3 normal;
};

/// True if surfaces with these unit normals can belong to one smoothing group: the normals differ by at most 30
/// degrees.
bool same_smoothing_group(Vec3 a, Vec3 b);

/// Hash of a position, rounded to a millionth of the diagonal of the scene, and a number `kind`. Positions that differ
/// by rounding errors almost always have the same hash.
std::uint64_t position_hash(const Scene& scene, Vec3 point, std::uint64_t kind);

/// True if an occluder, such as a wall on a floor, separates two nearby points of one smoothing group. A surface whose
/// front normal fits into the smoothing group of either point is no occluder.
bool occluded_between(const Scene& scene, const OpenPoint& a, const OpenPoint& b);

/// Accelerates occluded_between() for many pairs of points from one set of nearby points. Tests only the surfaces close
/// to the set, and leaves out those that fit into the smoothing group of every point of the set.
class NearbyOccluders
{
public:
    /// `normals`: unit front normals of all surfaces. `points`: the set. The scene must outlive this object.
    NearbyOccluders(const Scene& scene, const std::vector<Vec3>& normals, const std::vector<OpenPoint>& points);

    /// Equal to occluded_between() for two of the points.
    bool separate(const OpenPoint& a, const OpenPoint& b) const;

private:
    struct Near
    {
        std::uint32_t surface;
        Vec3 normal;
        Bounds box;
    };

    const Scene& scene_;
    std::vector<Near> near_; ///< the candidates
};

} // namespace multipath
