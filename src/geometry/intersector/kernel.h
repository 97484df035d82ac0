#pragma once

#include "geometry/hit.h"
#include "geometry/intersector/line_batch.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_table.h"
#include "geometry/line.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace multipath {

/// View of the hierarchy (see WideTree) for the search kernels.
struct TreeView
{
    const WideNode* nodes; ///< nodes[0] is the root
    const SurfaceBlock* leaves;
    bool is_large; ///< true if the leaves exceed the caches, so that prefetching them pays
};

/// A line of a LineBatch in the form that the search uses for slab tests. Along each axis, the line meets the plane at
/// coordinate c at t = c * inverse + at_zero. All t count from the middle of the line.
struct TreeLine
{
    float inverse[3];
    float at_zero[3];
    std::uint32_t near_plane[3]; ///< offset in WideNode::plane of the planes through which the line enters boxes
    std::uint32_t far_plane[3];  ///< offset in WideNode::plane of the planes through which the line leaves boxes
    float direction[3];
    float middle[3];
    float scale; ///< LineBatch::scale
    float first; ///< the search covers first <= t <= last
    float last;
    std::uint32_t number; ///< index of the line in the batch
};

/// A surface that a line may meet.
struct LineCandidate
{
    std::uint32_t line;    ///< index of the line in the batch
    std::uint32_t surface; ///< index of the surface in the SurfaceList
};

/// A subtree that a line has still to visit.
struct LineNode
{
    std::uint32_t line;  ///< index of the line in CandidateSearch::lines
    std::uint32_t child; ///< root of the subtree: node or leaf, as in WideNode::child
};

/// State of a search for all surfaces that some lines may meet. The surfaces are found in any order. The kernel works
/// in rounds until `pending` is empty, or until `pending` or `candidates` has room for fewer than `least_room` more
/// elements. In the latter case the caller makes room and calls the kernel again.
struct CandidateSearch
{
    static constexpr std::size_t at_once = 32;                               ///< entries taken from `pending` per round
    static constexpr std::size_t least_room = WideNode::lanes * at_once + 2; ///< most slots that a round writes

    const TreeLine* lines;
    LineNode* pending; ///< stack of the subtrees still to be visited
    std::size_t pending_count;
    std::size_t pending_room;  ///< capacity
    LineCandidate* candidates; ///< the surfaces found so far
    std::size_t candidate_count;
    std::size_t candidate_room; ///< capacity

    /// True if `pending` and `candidates` have room for another round.
    bool has_room() const
    {
        return pending_room - pending_count >= least_room && candidate_room - candidate_count >= least_room;
    }
};

/// The first hit of a ray among the surfaces tested so far.
struct NearestHit
{
    Hit best = {std::numeric_limits<double>::infinity(), 0, 0.0, 0.0, false}; ///< infinite t: no hit
    Hit back = {};         ///< hit on the back of a surface, at the same t as `best`, which is on a front; of several
                           ///< such surfaces, the smallest
    bool has_back = false; ///< true if `back` is valid

    bool is_hit() const { return best.t < std::numeric_limits<double>::infinity(); }
};

/// A ray of a batch whose first hit is sought. Lists of such rays must be sorted by number.
struct SearchedRay
{
    std::uint32_t number;  ///< index of the ray in the batch
    std::uint32_t from;    ///< index of the surface on which the ray starts; it lies in the excluded plane
    double excluded_plane; ///< SurfaceRow::plane of surfaces to ignore
};

/// Search for the first hits of some rays.
struct FirstHitSearch
{
    static constexpr unsigned at_once = 64; ///< rays that are traced together

    const LineBatch& batch;
    const Line* lines; ///< the lines of the batch
    const SearchedRay* rays;
    std::size_t ray_count;
    NearestHit* nearest;      ///< per line of the batch; in: a hit already known, or none; out: the first hit or, if
                              ///< `any` is true, some hit that is no farther than the known one; then only its
                              ///< surface may be valid
    bool any;                 ///< true: any hit nearer than the known one ends the search for its ray
    std::uint64_t* stacks;    ///< buffer for min(at_once, ray_count) stacks of stack_size elements
    std::uint32_t stack_size; ///< at least WideTree::most_pending() + 2

    /// Called, with `context`, for a hit at the same t as nearest.best; updates `nearest`.
    void (*take_coincident)(const void* context, NearestHit& nearest, const Hit& hit);
    const void* context;
};

/// The inner loops of the intersector, compiled for one instruction set. Filters find, in single precision and in the
/// coordinates of FilterFrame, a small superset of the surfaces that a line meets: the candidates. Hits are decided by
/// SurfaceTable::decide in double precision, so all kernels give the same results bit for bit.
struct FilterKernel
{
    const char* name; ///< name of the instruction set

    /// FilterFrame::place for up to LineBatch::most lines, stored in the entries 0 ... count - 1 of the batch.
    void (*place_lines)(const FilterFrame& frame, const Line* lines, std::size_t count, LineBatch& batch);

    /// Marks the surfaces that the lines 0 ... count - 1 of a batch may meet.
    void (*filter_flat)(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count, FlatMarks& marks);

    /// Finds the surface that each of the lines 0 ... count - 1 of a batch may meet first. Ignores for line i the
    /// surfaces whose plane number is excluded_planes[i]. This array must have LineBatch::most elements, aligned to 64
    /// bytes.
    void (*nearest_flat)(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count,
                         const float* excluded_planes, NearestCandidates& found);

    /// Prepares lines of the batch for the search in the hierarchy. `numbers`: their indices in the batch, in ascending
    /// order.
    void (*fill_tree_lines)(const LineBatch& batch, const std::uint32_t* numbers, std::size_t count, TreeLine* lines);

    /// Continues a search for candidates in the hierarchy until a list is full; see CandidateSearch.
    void (*find_candidates)(const TreeView& tree, CandidateSearch& search);

    /// Finds the first hits of rays in the hierarchy; see FirstHitSearch.
    void (*find_first)(const TreeView& tree, const SurfaceTable& table, const FirstHitSearch& search);

    /// Decides which candidates are hits. The candidates must be sorted by line. Writes the hits to `hits`, which must
    /// have room for `count` hits, and may change the elements behind the last hit. If line i has candidates, writes
    /// the number of hits of the lines 0 ... i to end_of_line[i]. Returns the total number of hits.
    std::size_t (*decide_candidates)(const SurfaceTable& table, const Line* lines, const LineCandidate* candidates,
                                     std::size_t count, Hit* hits, std::size_t* end_of_line);

    /// Decides whether line i meets surface surfaces[i]. is_hit[i] becomes 1 or 0; hits[i] is valid if it is 1.
    void (*decide_nearest)(const SurfaceTable& table, const Line* lines, const std::uint32_t* surfaces,
                           std::size_t count, Hit* hits, std::uint32_t* is_hit);
};

/// The kernels whose instruction set is usable (see parallel/instruction_set.h), fastest first. The plain kernel is
/// always among them.
std::vector<const FilterKernel*> available_kernels();

} // namespace multipath
