#pragma once

#include "base/memory.h"
#include "geometry/bounds.h"
#include "geometry/conditions.h"
#include "geometry/intersector/block_filling.h"
#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "geometry/intersector/kernel.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_table.h"
#include "geometry/intersector/tree.h"
#include "geometry/line.h"
#include "geometry/surface.h"

#include <cstddef>
#include <cstdint>
#include <optional>
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
    bool is_listed(std::uint32_t surface) const { return first_[surface] != unlisted; }

    /// False if the surface certainly has no neighbour: its list exists and is empty. True for an unlisted surface.
    bool may_have_some(std::uint32_t surface) const { return first_[surface] != empty_list; }

    /// Calls visit(other) for those neighbours of a listed surface whose boxes contain the point, in ascending order.
    template <class Visit>
    void for_each_around(std::uint32_t surface, Vec3 point_in_frame, const Visit& visit) const
    {
        const auto x = static_cast<float>(point_in_frame.x);
        const auto y = static_cast<float>(point_in_frame.y);
        const auto z = static_cast<float>(point_in_frame.z);
        for (const Neighbour* other = &neighbours_[first_[surface]]; other->surface != end_of_list; ++other)
            if (every(other->low[0] <= x, x <= other->high[0], other->low[1] <= y, y <= other->high[1],
                      other->low[2] <= z, z <= other->high[2]))
                visit(other->surface);
    }

private:
    static constexpr std::uint32_t unlisted = 0xffffffffu;
    static constexpr std::uint32_t empty_list = 0;
    static constexpr std::uint32_t end_of_list = 0xffffffffu;

    struct Neighbour
    {
        std::uint32_t surface; ///< end_of_list after the last neighbour of each list
        float low[3], high[3]; ///< box of the surface, in the frame
    };

    std::vector<std::uint32_t> first_;                            ///< per surface: offset of its list, or unlisted
    std::vector<Neighbour> neighbours_ = {{end_of_list, {}, {}}}; ///< all lists; the list at 0 is empty
};

/// Candidates of the lines of a batch: surfaces that passed the filter of a line (see LineCandidate). A list that is
/// filled again keeps its buffer.
struct CandidateList
{
    UnsetVector<LineCandidate> elements; ///< may hold more than `count`
    std::size_t count = 0;

    /// Makes room for at least `room` elements.
    void reserve(std::size_t room)
    {
        if (elements.size() < room)
            elements.resize(2 * room);
    }
};

/// Buffers of Core::search_tree, which finds candidates in the hierarchy.
struct CandidateScratch
{
    UnsetVector<TreeLine> lines;
    UnsetVector<LineNode> pending; ///< stack of subtrees still to be visited
    CandidateList found;           ///< in the order of the search
};

/// Buffers of Intersector::all_hits for one batch of lines: the data that one phase hands to the next.
struct HitLists::Scratch
{
    LineBatch batch{};
    bool all_whole = true;              ///< true if FilterLine::whole holds for all lines in `passing`
    std::vector<std::uint32_t> passing; ///< batch indices, ascending, of the lines that pass through the box
    FlatMarks marks{};
    CandidateScratch in_tree;
    CandidateList candidates; ///< the candidates of the batch, sorted by line
};

/// Buffers of Core::search_first, which finds first hits in the hierarchy.
struct FirstHitScratch
{
    std::vector<SearchedRay> rays;
    std::vector<NearestHit> nearest; ///< per line of the batch
    UnsetVector<std::uint64_t> stacks;
};

/// Buffers of Intersector::closest_hits_from and hits_on_targets.
struct FirstHits::Scratch
{
    LineBatch batch{};
    FirstHitScratch in_tree;
    std::vector<std::uint32_t> covered; ///< indices of the rays whose start is covered by another surface
    std::vector<Line> whole_lines;      ///< the covered rays, extended backwards
    HitLists along;                     ///< all hits along some of the whole lines
};

/// Data structures of an Intersector and the steps of its searches. Comments at the definitions explain the private
/// functions: building.cpp constructs, intersector.cpp answers queries for one line, batches.cpp those for many lines.
class Intersector::Core
{
public:
    Core(const SurfaceList& surfaces, const FilterKernel& kernel, int threads);

private:
    friend class Intersector;

    struct Groundwork; // the data structures built first

    Core(const SurfaceList& surfaces, Groundwork groundwork, const FilterKernel& kernel, int threads);
    std::vector<std::uint32_t> sort_out_unfiltered(const SurfaceList& surfaces, int threads);
    void fill_blocks();
    void fill_leaves(int threads);

    template <class Visit>
    void for_each_candidate(const Line& line, const Visit& visit) const;
    void all_hits(const Line& line, std::vector<Hit>& hits) const;
    std::optional<Hit> nearest(const Line& line, std::uint32_t excluded_plane) const;
    std::optional<Hit> first_of(const NearestHit& nearest, const Line& line, std::uint32_t excluded_plane) const;
    void take(const Hit& hit, NearestHit& nearest) const;
    void take_coincident(const Hit& hit, NearestHit& nearest) const;
    static constexpr std::uint32_t no_plane = 0xffffffffu; ///< as `excluded_plane`: no surface is ignored
    std::uint32_t plane_of(std::uint32_t from) const { return from == no_surface ? no_plane : plane_[from]; }
    double reach_of(const Line& ray) const;
    Line whole_line(const Line& ray) const; ///< the ray, extended to a line that starts before the scene
    std::optional<Hit> next_along(HitLists::List whole_line, std::uint32_t from, const Line& ray) const;
    template <class Visit>
    void for_each_around(std::uint32_t of, Vec3 point, const Visit& visit) const;
    template <class Visit>
    void for_each_coincident(std::uint32_t of, Vec3 point, const Visit& visit) const;

    FlatSurfaces flat_surfaces() const;
    bool is_covered(std::uint32_t from, Vec3 point) const;

    // The phases of all_hits, closest_hits_from and hits_on_targets for many lines. Trees with more than
    // largest_in_cache leaves (32 MB) exceed the caches.
    bool place_lines(const Line* lines, std::size_t count, HitLists::Scratch& work) const;
    void find_candidates(HitLists::Scratch& work) const;
    void find_among_few(HitLists::Scratch& work) const;
    void find_in_tree(HitLists::Scratch& work) const;
    TreeView tree_view() const { return {tree_.nodes(), leaves_.data(), leaves_.size() > largest_in_cache}; }
    static constexpr std::size_t largest_in_cache = (std::size_t{32} << 20) / sizeof(LeafBlock);
    void search_tree(const LineBatch& batch, const std::uint32_t* lines, std::size_t count,
                     CandidateScratch& work) const;
    LineCourse place_one(const Line& line, LineBatch& batch) const;
    static SearchedRay searched_ray(std::uint32_t number, std::uint32_t excluded_plane);
    void search_first(const LineBatch& batch, const Line* lines, bool any, FirstHitScratch& work) const;
    void decide_candidates(const Line* lines, std::size_t first, std::size_t last, HitLists& lists) const;
    void find_first_among_few(const std::uint32_t* from, const Line* rays, std::size_t first, std::size_t count,
                              FirstHits& found) const;
    void find_first_in_tree(const std::uint32_t* from, const std::uint32_t* targets, const Line* rays,
                            std::size_t first, std::size_t count, FirstHits& found) const;

    /// Order of hits along a line before order_coincident_hits: by t, then from small to large surfaces.
    bool comes_before(const Hit& a, const Hit& b) const
    {
        return a.t < b.t || (a.t == b.t && size_rank_[a.surface] < size_rank_[b.surface]);
    }
    void sort_many(Hit* hits, std::size_t count) const;
    void put_in_order(Hit* hits, std::size_t count) const;

    const FilterKernel* kernel_;
    SurfaceTable table_;
    FilterFrame frame_;
    WideTree tree_;                 ///< empty for few surfaces
    UnsetVector<LeafBlock> leaves_; ///< the leaves of tree_
    // If tree_ is empty, each surface that is not in unfiltered_ is stored in one lane of blocks_, in the order of
    // FlatSurfaces. With a tree, the members from here to blocks_ are empty.
    std::vector<std::uint32_t> lane_number_; ///< index of the surface in each lane
    std::vector<float> flat_number_;         ///< lane_number_ as floats: FlatSurfaces::number
    std::vector<float> flat_plane_;          ///< plane number of each lane: FlatSurfaces::plane
    unsigned flat_triangles_ = 0;            ///< number of triangles, which have the first lanes
    FramedRectangles framed_;                ///< the rectangles with a frame, which have the last lanes
    std::vector<SurfaceBlock> blocks_;
    std::vector<std::uint32_t> unfiltered_; ///< surfaces in no block or leaf; tested for every line in double precision
    bool outside_is_solid_;                 ///< true if is_interior(surfaces)
    std::vector<std::uint32_t> plane_;      ///< plane number of each surface (see SharedPlanes)
    std::vector<std::uint32_t> size_rank_;  ///< rank of each surface by area, 0 for the smallest, which lies on top
    PlaneNeighbours neighbours_;
};

} // namespace multipath
