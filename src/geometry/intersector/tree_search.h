#pragma once

#include "geometry/hit.h"
#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/line.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace multipath {

/// A hierarchy of surfaces as its searches see it.
struct TreeView
{
    const WideNode* nodes; ///< the first one is the root
    const LeafBlock* leaves;
    bool is_large; ///< so that leaves are fetched ahead from memory; where caches hold them, that takes time
};

/// What the searches need of a line: where it meets the planes x = c is c * inverse + at_zero, from its middle on.
struct TreeLine
{
    float inverse[3];
    float at_zero[3];
    std::uint32_t near_plane[3]; ///< place of the planes through which it enters boxes
    std::uint32_t far_plane[3];  ///< and through which it leaves them
    float direction[3];
    float backwards[3]; ///< -middle
    float scale;
    float first; ///< the part that is searched
    float last;
    std::uint32_t number; ///< in the batch
};

/// A surface that a line may meet.
struct LineCandidate
{
    std::uint32_t line; ///< number in the batch
    std::uint32_t surface;
};

/// A part of the hierarchy where a line has still to be searched.
struct LineNode
{
    std::uint32_t line; ///< place in the list of lines
    std::uint32_t child;
};

/// The search for all that some lines may meet, in any order. It goes on until nothing is pending or less than
/// `least_room` places are left for either list.
struct CandidateSearch
{
    static constexpr std::size_t at_once = 32;                               ///< children taken up together
    static constexpr std::size_t least_room = WideNode::lanes * at_once + 2; ///< what these can touch of a list

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

/// The first hit of a ray, as far as it has been searched.
struct NearestHit
{
    Hit best = {std::numeric_limits<double>::infinity(), 0, 0.0, 0.0, false}; ///< infinite t: none
    Hit back = {};         ///< the first that is met from behind where the best is met, from the front
    bool has_back = false; ///< there is one

    bool is_hit() const { return best.t < std::numeric_limits<double>::infinity(); }
};

/// A ray of a batch whose first hit is searched; the numbers of several grow.
struct SearchedRay
{
    std::uint32_t number;  ///< in the batch
    double excluded_plane; ///< SurfaceRow::plane of what it does not meet; no_plane: none

    static constexpr double no_plane = -1.0;
};

/// The search for the first hits of some rays.
struct FirstHitSearch
{
    static constexpr unsigned at_once = 64; ///< rays that are on their way together

    const LineBatch& batch;
    const Line* lines; ///< of the batch
    const SearchedRay* rays;
    std::size_t ray_count;
    NearestHit* nearest;   ///< of the batch; what is nearer than what it holds is looked for
    bool any;              ///< whatever is nearer ends the search of a ray
    std::uint64_t* stacks; ///< at_once of them, or as many as there are rays
    std::uint32_t stack_size;

    /// Takes a hit at the same place as the best one.
    void (*take_coincident)(const void* context, NearestHit& nearest, const Hit& hit);
    const void* context;
};

} // namespace multipath
