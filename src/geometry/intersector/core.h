#pragma once

#include "geometry/intersector/block_filling.h"
#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "geometry/intersector/kernel.h"
#include "geometry/intersector/plane_neighbours.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_table.h"
#include "geometry/intersector/tree.h"
#include "geometry/intersector/tree_search.h"
#include "geometry/line.h"
#include "geometry/surface.h"
#include "parallel/memory.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// Candidates of the lines of a batch. The buffer is reused.
struct CandidateList
{
    UnsetVector<LineCandidate> elements; ///< may hold more than `count`
    std::size_t count = 0;

    void reserve(std::size_t room)
    {
        if (elements.size() < room)
            elements.resize(2 * room);
    }
};

/// Buffers of a search for candidates in the hierarchy.
struct CandidateScratch
{
    UnsetVector<TreeLine> lines;
    UnsetVector<LineNode> pending;
    CandidateList found; ///< in the order of the search
};

/// Buffers of Intersector::all_hits for one batch of lines: the data that one phase hands to the next.
struct HitLists::Scratch
{
    LineBatch batch{};
    bool all_whole = true;              ///< FilterLine::whole of all lines that pass
    std::vector<std::uint32_t> passing; ///< batch indices of the lines that pass through the box
    FlatMarks marks{};
    CandidateScratch in_tree;
    CandidateList candidates; ///< sorted by line
};

/// Buffers of a search for first hits in the hierarchy.
struct FirstHitScratch
{
    std::vector<SearchedRay> rays;
    std::vector<NearestHit> nearest;
    UnsetVector<std::uint64_t> stacks;
};

/// Buffers of Intersector::closest_hits_from.
struct FirstHits::Scratch
{
    LineBatch batch{};
    FirstHitScratch in_tree;
    std::vector<std::uint32_t> covered; ///< rays that start at a point which another surface covers
    std::vector<Line> whole_lines;      ///< the covered rays, extended backwards
    HitLists along;                     ///< all hits along these lines
};

/// Data structures of an Intersector and the steps of its searches.
class Intersector::Core
{
public:
    Core(const SurfaceList& surfaces, const FilterKernel& kernel, int threads);

private:
    friend class Intersector;

    struct Groundwork;

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
    static constexpr std::uint32_t no_plane = 0xffffffffu;
    std::uint32_t plane_of(std::uint32_t from) const { return from == no_surface ? no_plane : plane_[from]; }
    double reach_of(const Line& ray) const;
    Line whole_line(const Line& ray) const; ///< the ray, extended backwards out of the scene
    std::optional<Hit> next_along(HitLists::List whole_line, std::uint32_t from, const Line& ray) const;
    template <class Visit>
    void for_each_around(std::uint32_t of, Vec3 point, const Visit& visit) const;
    template <class Visit>
    void for_each_coincident(std::uint32_t of, Vec3 point, const Visit& visit) const;

    FlatSurfaces flat_surfaces() const;
    bool is_covered(std::uint32_t from, Vec3 point) const;

    // The phases of all_hits and closest_hits_from for many lines.
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
    UnsetVector<LeafBlock> leaves_;          ///< of the tree
    std::vector<std::uint32_t> lane_number_; ///< without a tree: surface of each lane of the blocks
    std::vector<float> flat_number_;         ///< lane_number_
    std::vector<float> flat_plane_;          ///< plane number of each lane
    unsigned flat_triangles_ = 0;            ///< number of triangles, which have the first lanes
    FramedRectangles framed_;                ///< its rectangles have the last lanes
    std::vector<SurfaceBlock> blocks_;
    std::vector<std::uint32_t> unfiltered_; ///< surfaces in no block, tested in double precision against every line
    bool outside_is_solid_;                 ///< see is_interior
    std::vector<std::uint32_t> plane_;      ///< plane number of each surface
    std::vector<std::uint32_t> size_rank_;  ///< rank of each surface by size, 0 for the smallest, which lies on top
    PlaneNeighbours neighbours_;
};

} // namespace multipath
