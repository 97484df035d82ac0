#pragma once

#include "geometry/bvh.h"
#include "geometry/line.h"
#include "geometry/surface.h"
#include "geometry/surface_table.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// Where lines meet surfaces. Knows nothing of light; immutable and safe to share between threads.
/// Surfaces in one plane are met at exactly the same t, so coincident faces tie and are never lost.
class Intersector
{
public:
    /// Surfaces are numbered by their place in the list; each must have area.
    explicit Intersector(const std::vector<Surface>& surfaces);

    /// Every surface that the line meets, in the order in which it passes them (see order_coincident_hits for equal t).
    /// Replaces what `hits` held.
    void all_hits(const Line& line, std::vector<Hit>& hits) const;

    /// The first surface that the line meets; at equal t one that it meets from the front.
    std::optional<Hit> closest_hit(const Line& line) const;

    /// The first surface met by a ray that leaves `from` through its front. Nothing in the plane of `from` is met,
    /// except a coincident face that closes off the point where the ray starts (a box resting on a floor).
    std::optional<Hit> closest_hit_from(std::uint32_t from, const Line& ray) const;

    /// The surfaces that share the plane of `of` and hold `point`, a point of `of`; without `of` itself.
    std::vector<std::uint32_t> coincident_surfaces(std::uint32_t of, Vec3 point) const;

private:
    Intersector(const std::vector<Surface>& surfaces, const SharedPlanes& planes);
    std::optional<Hit> nearest(const Line& line, std::uint32_t excluded_plane) const;
    std::optional<Hit> next_along_whole_line(std::uint32_t from, const Line& ray) const;

    bool comes_before(const Hit& a, const Hit& b) const;
    void sort_along_line(std::vector<Hit>& hits) const;

    SurfaceTable table_;
    Bounds box_;                           ///< around all surfaces, widened
    Bvh bvh_;                              ///< empty for few surfaces
    bool outside_is_solid_;                ///< the surfaces are the inside of a room rather than the outside of things
    std::vector<std::uint32_t> plane_;     ///< plane number of each surface
    std::vector<std::uint32_t> size_rank_; ///< of each surface: 0 for the smallest; what is smaller lies on top
    std::vector<bool> plane_is_shared_;    ///< by more than one surface
};

} // namespace multipath
