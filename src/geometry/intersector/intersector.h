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

/// Where lines meet surfaces. Knows nothing of light; immutable and safe to share between threads.
/// Surfaces in one plane are met at exactly the same t, so coincident faces tie and are never lost.
/// Results do not depend on the kernel.
class Intersector
{
public:
    /// Surfaces are numbered by their place in the list; each must have area. The fastest kernel is chosen, or
    /// `kernel`, one of available_kernels(). What is built does not depend on the number of threads.
    explicit Intersector(const SurfaceList& surfaces, int threads = 1);
    Intersector(const SurfaceList& surfaces, const FilterKernel& kernel, int threads = 1);
    ~Intersector();
    Intersector(Intersector&&) noexcept;
    Intersector& operator=(Intersector&&) noexcept;

    /// Every surface that the line meets, in the order in which it passes them (see order_coincident_hits for equal t).
    /// Replaces what `hits` held.
    void all_hits(const Line& line, std::vector<Hit>& hits) const;

    /// The same for many lines, faster. Replaces what `lists` held.
    void all_hits(const Line* lines, std::size_t count, HitLists& lists) const;

    /// The first surface that the line meets; at equal t one that it meets from the front.
    std::optional<Hit> closest_hit(const Line& line) const;

    /// The first surface met by a ray that leaves `from` through its front. Nothing in the plane of `from` is met,
    /// except a coincident face that closes off the point where the ray starts (a box resting on a floor).
    std::optional<Hit> closest_hit_from(std::uint32_t from, const Line& ray) const;

    /// The same for many rays, faster. Replaces what `found` held. Rays from no_surface start in the open.
    static constexpr std::uint32_t no_surface = 0xffffffffu;
    void closest_hits_from(const std::uint32_t* from, const Line* rays, std::size_t count, FirstHits& found) const;

    /// The same where the first hit is on targets[i], none for the other rays; faster, as anything nearer ends a
    /// search.
    void hits_on_targets(const std::uint32_t* from, const std::uint32_t* targets, const Line* rays, std::size_t count,
                         FirstHits& found) const;

    /// The surfaces that share the plane of `of`, overlap it and hold `point`, a point of `of`.
    std::vector<std::uint32_t> coincident_surfaces(std::uint32_t of, Vec3 point) const;

    /// All surfaces that reach into the box, and others. None if there are so few surfaces that no list is faster.
    std::optional<std::vector<std::uint32_t>> surfaces_near(const Bounds& box) const;

    /// Where the line meets this surface, if it does.
    std::optional<Hit> hit_on(const Line& line, std::uint32_t surface) const;

    /// Of two surfaces in one plane that face the same way, which is met first? The smaller lies on top.
    bool is_over(std::uint32_t a, std::uint32_t b) const;
    /// Number of surfaces that coincident_surfaces looks at.
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
