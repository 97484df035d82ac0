#pragma once

#include "base/memory.h"
#include "geometry/bounds.h"
#include "geometry/conditions.h"
#include "geometry/intersector/block_filling.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "geometry/intersector/kernel.h"
#include "geometry/intersector/line_batch.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_table.h"
#include "geometry/intersector/tree.h"
#include "geometry/line.h"
#include "geometry/surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Precomputed lists: for each surface, its neighbours, the other surfaces in the same plane that overlap it. Most
/// lists are empty. Surfaces that only touch along their borders, like the triangles of a mesh, do not overlap.
class PlaneNeighbours
{
public:
    PlaneNeighbours() = default;
    /// `boxes`: the result of boxes_around_each. `plane_number`: SharedPlanes::plane_number. `tree`: hierarchy over the
    /// boxes, in the coordinates of `frame`. If the tree is empty or a plane has few surfaces, all pairs in the plane
    /// are compared.
    PlaneNeighbours(const SurfaceList& surfaces, const LargeVector<Bounds>& boxes,
                    const std::vector<std::uint32_t>& plane_number, const WideTree& tree, const FilterFrame& frame,
                    int threads);

    /// True if the surface has a list. Without a tree every surface has one; with a tree, a surface near too many
    /// others has none.
    bool is_listed(std::uint32_t surface) const
    {
        return lists_[surface].empty() || lists_[surface].front().surface != unlisted;
    }

    /// False if the surface certainly has no neighbour: its list exists and is empty. True for an unlisted surface.
    bool may_have_some(std::uint32_t surface) const { return !lists_[surface].empty(); }

    /// Calls visit(other) for those neighbours of a listed surface whose boxes contain the point, in ascending order.
    template <class Visit>
    void for_each_around(std::uint32_t surface, Vec3 point_in_frame, const Visit& visit) const
    {
        const auto x = static_cast<float>(point_in_frame.x);
        const auto y = static_cast<float>(point_in_frame.y);
        const auto z = static_cast<float>(point_in_frame.z);
        for (const Neighbour& other : lists_[surface])
            if (every(other.low[0] <= x, x <= other.high[0], other.low[1] <= y, y <= other.high[1], other.low[2] <= z,
                      z <= other.high[2]))
                visit(other.surface);
    }

private:
    static constexpr std::uint32_t unlisted = 0xffffffffu;

    struct Neighbour
    {
        std::uint32_t surface;
        float low[3], high[3]; ///< box of the surface, in the frame
    };

    std::vector<std::vector<Neighbour>> lists_; ///< per surface; if it has none: a single neighbour `unlisted`
};

/// Buffers of Core::all_hits for one batch of lines: the data that one phase hands to the next.
struct CandidateBuffers
{
    LineBatch batch{};
    FlatMarks marks{};
    UnsetVector<std::uint32_t> passing; ///< batch indices, ascending, of the lines that pass through the box
    UnsetVector<TreeLine> tree_lines;
    UnsetVector<LineNode> pending;           ///< stack of subtrees still to be visited
    UnsetVector<LineCandidate> found;        ///< in the order of the search
    UnsetVector<LineCandidate> candidates{}; ///< sorted by line
};

/// Rays whose first hits are sought, and where these are stored. See Intersector::hits_on_targets.
struct RayQuery
{
    const std::uint32_t* from;
    const std::uint32_t* targets; ///< or null; the first hit of ray i is certain only if it is on surface targets[i]
    const Line* rays;
    std::size_t count;
    FirstHits& found;
};

/// A ray that meets a front and a back with different outlines at the same t.
struct Tie
{
    std::size_t ray;
    NearestHit nearest;
};

/// Buffers of Core::find_first.
struct FirstHitBuffers
{
    LineBatch batch{};
    std::vector<SearchedRay> searched;
    std::vector<NearestHit> nearest; ///< per ray of the batch
    UnsetVector<std::uint64_t> stacks;
    std::vector<std::size_t> undecided; ///< rays of the query of which all candidates are tested
    CandidateBuffers candidates;        ///< of these
    std::vector<Tie> ties;
    std::vector<std::size_t> covered; ///< rays whose start is covered by another surface
    std::vector<Line> lines;          ///< the undecided rays, then those of ties, then those covered
};

/// Data structures of an Intersector and the steps of its searches. Comments at the definitions explain the functions:
/// building.cpp constructs, batches.cpp searches, intersector.cpp orders hits and answers other questions.
struct Intersector::Core
{
    Core(const SurfaceList& surfaces, const FilterKernel& kernel, int threads, std::size_t enclosing);
    std::vector<std::uint32_t> sort_out_unfiltered(const SurfaceList& surfaces, int threads);
    void store_flat(FramedRectangles framed);
    void store_leaves(int threads);

    std::size_t place_lines(const Line* lines, std::size_t count, LineBatch& batch) const;

    void all_hits(const Line* lines, std::size_t count, HitLists& lists) const;
    void find_candidates(std::size_t count, CandidateBuffers& work) const;
    void filter_few(std::size_t count, CandidateBuffers& work) const;
    void search_tree(CandidateBuffers& work) const;
    bool filters_all(std::size_t lines) const;
    TreeView tree_view() const { return {tree_.nodes(), leaves_.data(), leaves_.size() > largest_in_cache}; }
    /// Trees with more leaves (32 MB) exceed the caches.
    static constexpr std::size_t largest_in_cache = (std::size_t{32} << 20) / sizeof(SurfaceBlock);

    void find_first(const RayQuery& query) const;
    void find_first_by_bounds(const RayQuery& query, std::size_t first, std::size_t count, FirstHitBuffers& work) const;
    void find_first_of_undecided(const RayQuery& query, FirstHitBuffers& work) const;
    void find_first_in_tree(const RayQuery& query, std::size_t first, std::size_t count, FirstHitBuffers& work) const;
    void put(const RayQuery& query, std::size_t ray, const NearestHit& nearest, std::vector<Tie>& ties) const;
    void order_ties(const RayQuery& query, FirstHitBuffers& work) const;
    void find_covered(const RayQuery& query, std::vector<std::size_t>& covered) const;
    void find_first_of_covered(const RayQuery& query, FirstHitBuffers& work) const;
    template <class Visit>
    void for_each_whole_line(const std::vector<Line>& rays, const Visit& visit) const;
    void take_surface(const Line& line, std::uint32_t excluded_plane, std::uint32_t surface, NearestHit& nearest) const;
    void take_coincident(const Hit& hit, NearestHit& nearest) const;
    static constexpr std::uint32_t no_plane = 0xffffffffu; ///< as `excluded_plane`: no surface is ignored
    std::uint32_t plane_of(std::uint32_t from) const { return from == no_surface ? no_plane : plane_[from]; }
    double reach_of(const Line& ray) const;

    /// Order of hits along a line before order_coincident_hits: by t, then from small to large surfaces.
    bool comes_before(const Hit& a, const Hit& b) const
    {
        return a.t < b.t || (a.t == b.t && is_over(a.surface, b.surface));
    }
    bool is_over(std::uint32_t a, std::uint32_t b) const
    {
        return area_[a] < area_[b] || (area_[a] == area_[b] && a > b);
    }
    void put_in_order(Hit* hits, std::size_t count) const;
    void order_coincident(Hit* hits, std::size_t count) const;
    bool has_shell() const { return first_enclosing_ < plane_.size(); }

    template <class Visit>
    void for_each_around(std::uint32_t of, Vec3 point, const Visit& visit) const;
    template <class Visit>
    void for_each_coincident(std::uint32_t of, Vec3 point, const Visit& visit) const;
    bool is_covered(std::uint32_t from, Vec3 point) const;

    const FilterKernel* kernel_;
    SurfaceTable table_;
    FilterFrame frame_;
    WideTree tree_; ///< over all surfaces that are not in unfiltered_
    UnsetVector<SurfaceBlock> leaves_;
    bool is_few_ = false; ///< true if FlatSurfaces has the surfaces of the tree, too; else the next members are empty
    FramedRectangles framed_;
    UnsetVector<SurfaceBlock> flat_blocks_;
    std::vector<std::uint32_t> flat_surface_; ///< index of each surface of FlatSurfaces
    std::vector<float> flat_plane_;           ///< FlatSurfaces::plane
    FlatSurfaces flat_{};                     ///< view of the four members before
    std::vector<std::uint32_t> unfiltered_;   ///< surfaces that cannot be filtered: candidates of every line
    std::size_t first_enclosing_;             ///< the surfaces from here on are a shell around the others
    bool outside_is_solid_;                   ///< true if is_interior() of the others
    std::vector<std::uint32_t> plane_;        ///< plane number of each surface (see SharedPlanes)
    std::vector<double> area_;                ///< of each surface; the smallest of several in one place lies on top
    PlaneNeighbours neighbours_;
};

} // namespace multipath
