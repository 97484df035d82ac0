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

/// The inner loops of the intersector, compiled for one instruction set. Filters find, in single precision and in the
/// coordinates of FilterFrame, a small superset of the surfaces that a line meets. Hits are decided in double
/// precision, so that all kernels give the same results bit for bit.
struct FilterKernel
{
    const char* name; ///< name of the instruction set

    /// FilterFrame::place for up to LineBatch::most lines.
    void (*place_lines)(const FilterFrame& frame, const Line* lines, std::size_t count, LineBatch& batch);

    /// Marks the surfaces that the lines 0 ... count - 1 of a batch may meet. `whole`: FilterLine::whole of all of
    /// them.
    void (*filter_flat)(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count, bool whole,
                        FlatMarks& marks);

    /// Finds the surface that each line of a batch may meet first, ignoring for line i the surfaces in plane number
    /// excluded_planes[i] (aligned like a batch).
    void (*nearest_flat)(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count,
                         const float* excluded_planes, NearestCandidates& found);

    /// Tests one line: bit b % 4 * 16 + i of masks[b / 4] is set if it may meet lane i of block b.
    void (*filter_line)(const SurfaceBlock* blocks, std::uint32_t block_count, const FilterLine& line,
                        std::uint64_t* masks);

    /// Prepares the lines of a batch with these indices, in ascending order, for the search in the hierarchy.
    void (*fill_tree_lines)(const LineBatch& batch, const std::uint32_t* numbers, std::size_t count, TreeLine* lines);

    /// Continues a search in the hierarchy; see CandidateSearch.
    void (*find_candidates)(const TreeView& tree, CandidateSearch& search);

    /// Finds the first hits of rays in the hierarchy.
    void (*find_first)(const TreeView& tree, const SurfaceTable& table, const FirstHitSearch& search);

    /// Decides the candidates, which must be sorted by line. Writes the hits to `hits`, which must have room for one
    /// more than there are candidates, and the number of hits up to and including line i to end_of_line[i], if line i
    /// has candidates. Returns the total number of hits.
    std::size_t (*decide_candidates)(const SurfaceTable& table, const Line* lines, const LineCandidate* candidates,
                                     std::size_t count, Hit* hits, std::size_t* end_of_line);

    /// Decides one surface for each line; hits[i] is valid if is_hit[i].
    void (*decide_nearest)(const SurfaceTable& table, const Line* lines, const std::uint32_t* surfaces,
                           std::size_t count, Hit* hits, std::uint32_t* is_hit);
};

/// The kernels whose instruction set is usable, fastest first; the plain one is always among them.
std::vector<const FilterKernel*> available_kernels();

} // namespace multipath
