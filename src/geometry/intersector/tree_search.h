#pragma once

#include "geometry/hit.h"
#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/line.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace multipath {

/// View of the hierarchy for the search kernels.
struct TreeView
{
    const WideNode* nodes; ///< nodes[0] is the root
    const LeafBlock* leaves;
    bool is_large; ///< larger than the caches, so that prefetching leaves pays
};

/// Line in the form that the search uses for slab tests: along each axis it meets the plane at coordinate c at
/// t = c * inverse + at_zero, measured from its middle.
struct TreeLine
{
    float inverse[3];
    float at_zero[3];
    std::uint32_t near_plane[3]; ///< offset in WideNode::plane of the planes through which it enters boxes
    std::uint32_t far_plane[3];  ///< likewise of those through which it leaves
    float direction[3];
    float backwards[3]; ///< -middle
    float scale;
    float first; ///< interval of t that is searched
    float last;
    std::uint32_t number; ///< index in the batch
};

/// A surface that a line may meet.
struct LineCandidate
{
    std::uint32_t line; ///< index in the batch
    std::uint32_t surface;
};

/// A subtree that a line has still to visit.
struct LineNode
{
    std::uint32_t line;  ///< index in the list of lines
    std::uint32_t child; ///< as in WideNode
};

/// State of a search for all surfaces that some lines may meet, in any order. The kernel proceeds until nothing is
/// pending or one of the two lists has room for fewer than `least_room` more elements.
struct CandidateSearch
{
    static constexpr std::size_t at_once = 32;                               ///< children taken from the list per round
    static constexpr std::size_t least_room = WideNode::lanes * at_once + 2; ///< slots that a round may write

    const TreeLine* lines;
    LineNode* pending;
    std::size_t pending_count;
    std::size_t pending_room;
    LineCandidate* candidates;
    std::size_t candidate_count;
    std::size_t candidate_room;

    bool has_room() const
    {
        return pending_room - pending_count >= least_room && candidate_room - candidate_count >= least_room;
    }
};

/// The first hit of a ray among the surfaces tested so far.
struct NearestHit
{
    Hit best = {std::numeric_limits<double>::infinity(), 0, 0.0, 0.0, false}; ///< infinite t: no hit
    Hit back = {};         ///< first hit on a back at the same t, if `best` is on a front
    bool has_back = false; ///< `back` is valid

    bool is_hit() const { return best.t < std::numeric_limits<double>::infinity(); }
};

/// A ray of a batch whose first hit is sought. Lists of them have ascending numbers.
struct SearchedRay
{
    std::uint32_t number;  ///< index in the batch
    double excluded_plane; ///< SurfaceRow::plane of surfaces to ignore, or no_plane

    static constexpr double no_plane = -1.0;
};

/// Search for the first hits of some rays.
struct FirstHitSearch
{
    static constexpr unsigned at_once = 64; ///< rays that are traced together

    const LineBatch& batch;
    const Line* lines; ///< the lines of the batch
    const SearchedRay* rays;
    std::size_t ray_count;
    NearestHit* nearest;   ///< in and out, per line of the batch: only hits that are not farther are sought
    bool any;              ///< any nearer hit ends the search of a ray
    std::uint64_t* stacks; ///< min(at_once, ray_count) stacks
    std::uint32_t stack_size;

    /// Called for a hit at the same t as the best one.
    void (*take_coincident)(const void* context, NearestHit& nearest, const Hit& hit);
    const void* context;
};

} // namespace multipath
