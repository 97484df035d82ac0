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
/// coordinates of FilterFrame, a small superset of the surfaces that a line meets: the candidates. Hits are decided by
/// SurfaceTable::decide in double precision, so all kernels give the same results bit for bit.
struct FilterKernel
{
    const char* name; ///< name of the instruction set

    /// FilterFrame::place for up to LineBatch::most lines, stored in the entries 0 ... count - 1 of the batch.
    void (*place_lines)(const FilterFrame& frame, const Line* lines, std::size_t count, LineBatch& batch);

    /// Marks the surfaces that the lines 0 ... count - 1 of a batch may meet. `whole`: true if FilterLine::whole holds
    /// for all of these lines that pass through the box; tests of t are omitted then.
    void (*filter_flat)(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count, bool whole,
                        FlatMarks& marks);

    /// Finds the surface that each of the lines 0 ... count - 1 of a batch may meet first. Ignores for line i the
    /// surfaces whose plane number is excluded_planes[i]. This array must have LineBatch::most elements, aligned to 64
    /// bytes.
    void (*nearest_flat)(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count,
                         const float* excluded_planes, NearestCandidates& found);

    /// Tests one line: sets bit b % 4 * 16 + i of masks[b / 4] if the line may meet the surface in lane i of block b,
    /// and clears the bit otherwise.
    void (*filter_line)(const SurfaceBlock* blocks, std::uint32_t block_count, const FilterLine& line,
                        std::uint64_t* masks);

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
