#pragma once

#include "geometry/vec3.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

// A skin: surfaces that look like one, such as the triangles of a sphere, and are shaded as one (a smoothing group).

/// A point of a skin in the open, with the unit normal there.
struct OpenPoint
{
    Vec3 point;
    Vec3 normal;
};

/// True if surfaces with these unit normals can belong to one skin; false if there is a crease between them.
bool level(Vec3 a, Vec3 b);

/// Hash of a position, rounded to a millionth of the scene, and a kind of thing there.
std::uint64_t place_key(const Scene& scene, Vec3 point, std::uint64_t kind);

/// True if something such as a wall on a floor stands between two nearby points of one skin. Surfaces level with one of
/// the points do not count.
bool parted(const Scene& scene, const OpenPoint& a, const OpenPoint& b);

/// The same for many pairs of points near each other: tests only the surfaces nearby that are not level with all of the
/// points.
class Surroundings
{
public:
    /// `points`: those that will be asked for; `normals`: of all surfaces. The scene must outlive this object.
    Surroundings(const Scene& scene, const std::vector<Vec3>& normals, const std::vector<OpenPoint>& points);

    /// True if no two of the points are parted.
    bool part_nothing() const { return near_ && near_->empty(); }
    /// parted() for two of the points.
    bool part(const OpenPoint& a, const OpenPoint& b) const;

private:
    struct Near
    {
        std::uint32_t surface;
        Vec3 normal;
        Bounds box;
    };

    const Scene& scene_;
    std::optional<std::vector<Near>> near_; ///< none: all surfaces
};

} // namespace multipath
