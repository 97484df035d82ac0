#pragma once

#include "geometry/hit.h"
#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_table.h"
#include "geometry/intersector/tree_search.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// The filters, compiled for one instruction set. All find what may be met, hardly any more, in the coordinates of
/// FilterFrame; what is met is decided in double precision, so that all lead to the same results bit for bit.
struct FilterKernel
{
    const char* name; ///< of the instruction set

    /// Places up to LineBatch::most lines.
    void (*place_lines)(const FilterFrame& frame, const Line* lines, std::size_t count, LineBatch& batch);

    /// Tests the lines 0 ... count - 1 of a batch. `whole`: all of them are (see FilterLine).
    void (*filter_flat)(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count, bool whole,
                        FlatMarks& marks);

    /// For every line of a batch the surface that it may meet first, not counting those whose plane number is
    /// excluded_planes[i] (aligned like a batch).
    void (*nearest_flat)(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count,
                         const float* excluded_planes, NearestCandidates& found);

    /// Tests one line: bit b % 4 * 16 + i of masks[b / 4] tells whether it may meet lane i of block b.
    void (*filter_line)(const SurfaceBlock* blocks, std::uint32_t block_count, const FilterLine& line,
                        std::uint64_t* masks);

    /// Puts lines of a batch into the form in which the hierarchy is searched; their numbers grow.
    void (*fill_tree_lines)(const LineBatch& batch, const std::uint32_t* numbers, std::size_t count, TreeLine* lines);

    /// Goes on with a search in the hierarchy; see CandidateSearch.
    void (*find_candidates)(const TreeView& tree, CandidateSearch& search);

    /// Finds the first hits of rays in the hierarchy.
    void (*find_first)(const TreeView& tree, const SurfaceTable& table, const FirstHitSearch& search);

    /// Decides candidates, those of one line next to each other. Appends what is met to `hits`, which must have room
    /// for all and one more; end_of_line[i]: how many hits there are after line i, if it has candidates. Returns how
    /// many there are in all.
    std::size_t (*decide_candidates)(const SurfaceTable& table, const Line* lines, const LineCandidate* candidates,
                                     std::size_t count, Hit* hits, std::size_t* end_of_line);

    /// Decides one surface for each line; hits[i] is one if is_hit[i].
    void (*decide_nearest)(const SurfaceTable& table, const Line* lines, const std::uint32_t* surfaces,
                           std::size_t count, Hit* hits, std::uint32_t* is_hit);
};

/// Those whose instruction set is usable, the fastest first; the plain one is always there.
std::vector<const FilterKernel*> available_kernels();

} // namespace multipath
