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

struct FilterKernel;

/// Finds the intersections of lines and surfaces. It is independent of light, immutable and safe to share between
/// threads. A line meets all surfaces in one plane at exactly the same t, so that coincident faces tie and none is
/// lost. Results do not depend on the kernel.
class Intersector
{
public:
    /// Surfaces are identified by their index in the list; each must have an area above zero. Uses the fastest of
    /// available_kernels() or the given one. The data structures built do not depend on the number of threads.
    explicit Intersector(const SurfaceList& surfaces, int threads = 1);
    Intersector(const SurfaceList& surfaces, const FilterKernel& kernel, int threads = 1);
    ~Intersector();
    Intersector(Intersector&&) noexcept;
    Intersector& operator=(Intersector&&) noexcept;

    /// Finds all surfaces that the line meets, in order along the line (see order_coincident_hits for equal t).
    /// Overwrites `hits`.
    void all_hits(const Line& line, std::vector<Hit>& hits) const;

    /// The same for many lines, faster. Overwrites `lists`.
    void all_hits(const Line* lines, std::size_t count, HitLists& lists) const;

    /// Returns the first hit of the line; at equal t, one on a front if there is one.
    std::optional<Hit> closest_hit(const Line& line) const;

    /// Returns the first hit of a ray that leaves surface `from` through its front. Surfaces in the plane of `from` are
    /// ignored, except a coincident face that covers the start of the ray (a box resting on a floor).
    std::optional<Hit> closest_hit_from(std::uint32_t from, const Line& ray) const;

    /// The same for many rays, faster. Overwrites `found`. `no_surface` marks a ray that does not start on a surface.
    static constexpr std::uint32_t no_surface = 0xffffffffu;
    void closest_hits_from(const std::uint32_t* from, const Line* rays, std::size_t count, FirstHits& found) const;

    /// The same, but ray i keeps its first hit only if it is on surface targets[i]. Faster, because any nearer hit ends
    /// the search.
    void hits_on_targets(const std::uint32_t* from, const std::uint32_t* targets, const Line* rays, std::size_t count,
                         FirstHits& found) const;

    /// The other surfaces in the plane of `of` that overlap it and contain `point`, a point of `of`.
    std::vector<std::uint32_t> coincident_surfaces(std::uint32_t of, Vec3 point) const;

    /// A superset of the surfaces that reach into the box. std::nullopt if the scene is so small that testing all
    /// surfaces is faster.
    std::optional<std::vector<std::uint32_t>> surfaces_near(const Bounds& box) const;

    /// The hit of the line on this surface, if they meet.
    std::optional<Hit> hit_on(const Line& line, std::uint32_t surface) const;

    /// True if `a` lies on top of `b`, where both are in one plane and face the same way: the smaller one is on top.
    bool is_over(std::uint32_t a, std::uint32_t b) const;
    /// Number of surfaces that coincident_surfaces tests, a measure of its cost.
    std::size_t surfaces_around(std::uint32_t of, Vec3 point) const;

private:
    class Core;

    void append_one_by_one(const Line* lines, std::size_t first, std::size_t last, HitLists& lists) const;
    void find_first(const std::uint32_t* from, const std::uint32_t* targets, const Line* rays, std::size_t count,
                    FirstHits& found) const;
    void find_first_of_covered(const std::uint32_t* from, const Line* rays, std::size_t count, FirstHits& found) const;

    std::unique_ptr<const Core> core_;
};

} // namespace multipath
