#pragma once

#include "geometry/intersector/block_filling.h"
#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/kernel.h"
#include "geometry/intersector/plane_neighbours.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_table.h"
#include "geometry/intersector/tree.h"
#include "geometry/line.h"
#include "geometry/surface.h"
#include "parallel/memory.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// Where lines meet surfaces. Knows nothing of light; immutable and safe to share between threads.
/// Surfaces in one plane are met at exactly the same t, so coincident faces tie and are never lost.
/// Results do not depend on the kernel.
class Intersector
{
public:
    /// Surfaces are numbered by their place in the list; each must have area. `kernel`: one of available_kernels().
    /// What is built does not depend on the number of threads.
    explicit Intersector(const SurfaceList& surfaces, const FilterKernel& kernel = *available_kernels()[0],
                         int threads = 1);

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

    /// The same for many rays, faster. Replaces what `found` held.
    void closest_hits_from(const std::uint32_t* from, const Line* rays, std::size_t count, FirstHits& found) const;

    /// The surfaces that share the plane of `of` and hold `point`, a point of `of`; without `of` itself.
    std::vector<std::uint32_t> coincident_surfaces(std::uint32_t of, Vec3 point) const;

    /// All surfaces that reach into the box, and others. None if there are so few surfaces that no list is faster.
    std::optional<std::vector<std::uint32_t>> surfaces_near(const Bounds& box) const;

    /// Does the line meet this surface?
    bool meets(const Line& line, std::uint32_t surface) const
    {
        Hit hit;
        return table_.decide(line, surface, hit);
    }

    /// Of two surfaces in one plane that face the same way, which is met first? The smaller lies on top.
    bool is_over(std::uint32_t a, std::uint32_t b) const { return size_rank_[a] < size_rank_[b]; }
    /// How many surfaces are looked at to find these.
    std::size_t surfaces_around(std::uint32_t of, Vec3 point) const;

private:
    struct Nearest;
    struct Groundwork;

    Intersector(const SurfaceList& surfaces, Groundwork groundwork, const FilterKernel& kernel, int threads);
    std::vector<std::uint32_t> sort_out_unfiltered(const SurfaceList& surfaces, int threads);
    void fill_blocks(int threads);

    template <class Visit>
    void for_each_candidate(const Line& line, const Visit& visit) const;
    std::optional<Hit> nearest(const Line& line, std::uint32_t excluded_plane) const;
    std::optional<Hit> nearest_in_tree(const Line& line, const FilterLine& placed, std::uint32_t excluded_plane) const;
    double reach_of(const Line& ray) const;
    Line whole_line(const Line& ray) const; ///< the ray and what lies behind its start
    std::optional<Hit> next_along(HitLists::List whole_line, std::uint32_t from, const Line& ray) const;
    template <class Visit>
    void for_each_around(std::uint32_t of, Vec3 point, const Visit& visit) const;
    template <class Visit>
    void for_each_coincident(std::uint32_t of, Vec3 point, const Visit& visit) const;

    FlatSurfaces flat_surfaces() const;
    bool is_covered(std::uint32_t from, Vec3 point) const;

    // The phases of all_hits and closest_hits_from for many lines.
    bool place_lines(const Line* lines, std::size_t count, HitLists& lists) const;
    void find_candidates(HitLists& lists) const;
    void find_among_few(HitLists& lists) const;
    void find_in_tree(HitLists& lists) const;
    void decide_candidates(const Line* lines, std::size_t first, std::size_t last, HitLists& lists) const;
    void append_one_by_one(const Line* lines, std::size_t first, std::size_t last, HitLists& lists) const;
    void find_first_among_few(const std::uint32_t* from, const Line* rays, std::size_t first, std::size_t count,
                              FirstHits& found) const;
    void find_first_in_tree(const std::uint32_t* from, const Line* rays, std::size_t first, std::size_t count,
                            FirstHits& found) const;
    void find_first_of_covered(const std::uint32_t* from, const Line* rays, std::size_t count, FirstHits& found) const;

    bool comes_before(const Hit& a, const Hit& b) const
    {
        return a.t < b.t || (a.t == b.t && size_rank_[a.surface] < size_rank_[b.surface]);
    }
    void sort_many(Hit* hits, std::size_t count) const;
    void put_in_order(Hit* hits, std::size_t count) const;

    const FilterKernel* kernel_;
    SurfaceTable table_;
    FilterFrame frame_;
    WideTree tree_;                          ///< empty for few surfaces
    LargeVector<std::uint32_t> lane_number_; ///< surface in each lane of the blocks
    std::vector<float> flat_number_;         ///< without a tree: lane_number_
    std::vector<float> flat_plane_;          ///< without a tree: plane numbers of the same
    unsigned flat_triangles_ = 0;            ///< without a tree: the first lanes
    FramedRectangles framed_;                ///< without a tree: the last lanes
    UnsetVector<SurfaceBlock> blocks_;
    std::vector<std::uint32_t> unfiltered_; ///< surfaces in no block, which every line must be decided against
    bool outside_is_solid_;                 ///< the surfaces are the inside of a room rather than the outside of things
    std::vector<std::uint32_t> plane_;      ///< plane number of each surface
    std::vector<std::uint32_t> size_rank_;  ///< of each surface: 0 for the smallest; what is smaller lies on top
    PlaneNeighbours neighbours_;
};

} // namespace multipath
