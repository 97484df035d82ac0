#pragma once

#include "geometry/bounds.h"
#include "geometry/hit.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/line.h"
#include "geometry/surface.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace multipath {

struct FilterKernel; // see kernel.h

/// Finds the intersections of lines and surfaces, independent of light. An intersector is immutable and safe to share
/// between threads. If a plane contains surfaces that face opposite ways, a line meets all surfaces in it at exactly
/// the same t (see SharedPlanes), so that no hit on touching faces is lost. Results do not depend on the kernel.
class Intersector
{
public:
    /// Surfaces are identified by their index in the list; each must have an area above zero, and there must be fewer
    /// than 2^26 of them. Lines are tested by the given kernel or else the fastest of available_kernels(). The data
    /// structures built do not depend on the number of threads. The last `enclosing` surfaces are a shell around all
    /// others, such as a sky, and look inwards.
    explicit Intersector(const SurfaceList& surfaces, int threads = 1, std::size_t enclosing = 0);
    Intersector(const SurfaceList& surfaces, const FilterKernel& kernel, int threads = 1, std::size_t enclosing = 0);
    ~Intersector();
    Intersector(Intersector&&) noexcept;
    Intersector& operator=(Intersector&&) noexcept;

    /// Finds the hits of the line (0 <= t <= t_max) with all surfaces, in order along the line (see
    /// order_coincident_hits for equal t). Overwrites `hits`.
    void all_hits(const Line& line, std::vector<Hit>& hits) const;

    /// The same for `count` lines, faster. Overwrites `lists`; list i belongs to line i.
    void all_hits(const Line* lines, std::size_t count, HitLists& lists) const;

    /// Returns the first hit of the line, or std::nullopt if there is none. Of several hits at the same t, one on a
    /// front is preferred, then the smallest surface.
    std::optional<Hit> closest_hit(const Line& line) const;

    /// Returns the first hit of a ray that starts on surface `from` and leaves it, or std::nullopt. Surfaces in the
    /// plane of `from` are ignored unless one of them covers the start of the ray, like a box resting on a floor. Then
    /// the ray is extended backwards to a whole line, and the result is the hit that follows the hit on `from`. If a
    /// front and a back with different outlines are met at the same t, the first of them in the order of all_hits is
    /// returned; other ties are resolved as in closest_hit.
    std::optional<Hit> closest_hit_from(std::uint32_t from, const Line& ray) const;

    static constexpr std::uint32_t no_surface = 0xffffffffu; ///< from[i] of a ray that starts on no surface
    /// The same for `count` rays, faster: ray i starts on surface from[i], or on none if from[i] is `no_surface`.
    /// Overwrites `found`.
    void closest_hits_from(const std::uint32_t* from, const Line* rays, std::size_t count, FirstHits& found) const;

    /// Like closest_hits_from, but ray i keeps its first hit only if that hit is on surface targets[i]. Faster in large
    /// scenes, because any hit before the target ends the search.
    void hits_on_targets(const std::uint32_t* from, const std::uint32_t* targets, const Line* rays, std::size_t count,
                         FirstHits& found) const;

    /// The other surfaces in the plane of surface `of` that contain `point`, a point of `of`, in no particular order.
    /// Surfaces that only touch the border of `of` are left out, unless too many surfaces lie near `of` (see
    /// PlaneNeighbours::is_listed).
    std::vector<std::uint32_t> coincident_surfaces(std::uint32_t of, Vec3 point) const;

    /// A superset of the surfaces that reach into the box, in no particular order.
    std::vector<std::uint32_t> surfaces_near(const Bounds& box) const;

    /// The hit of the line on this surface, or std::nullopt if they do not meet.
    std::optional<Hit> hit_on(const Line& line, std::uint32_t surface) const;

    /// True if `a` lies on top of `b`, where both are in one plane and face the same way. The smaller surface is on
    /// top; of two with the same area, the one with the larger index.
    bool is_over(std::uint32_t a, std::uint32_t b) const;
    /// Number of surfaces that coincident_surfaces(of, point) tests, a measure of its cost.
    std::size_t surfaces_around(std::uint32_t of, Vec3 point) const;

private:
    struct Core;

    std::unique_ptr<const Core> core_;
};

} // namespace multipath
