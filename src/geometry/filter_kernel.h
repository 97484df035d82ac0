#pragma once

#include "geometry/filter_line.h"
#include "geometry/surface_block.h"
#include "geometry/wide_node.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Lanes of a block, one bit each.
struct BlockLanes
{
    std::uint32_t block;
    unsigned lanes;
};

/// Takes surfaces that a line may meet.
using VisitBlocks = void (*)(void* context, const BlockLanes* found, unsigned count);

/// Takes the surfaces of a block that a line may meet (bit i: lane i). Returns how far from the line's middle the
/// search is to go on.
using VisitBlock = float (*)(void* context, std::uint32_t block, unsigned lanes);

/// The filters, compiled for one instruction set. All find what may be met, hardly any more, in the coordinates of
/// FilterFrame; what is met is decided in double precision, so that all lead to the same results bit for bit.
struct FilterKernel
{
    const char* name; ///< plain, sse2, avx2 or avx512

    /// Places up to LineBatch::most lines.
    void (*place_lines)(const FilterFrame& frame, const Line* lines, std::size_t count, LineBatch& batch);

    /// Tests lines of a batch, by their numbers, against blocks 0 ... block_count - 1: bit b % 4 * 16 + i of masks[n *
    /// words + b / 4] tells whether line numbers[n] may meet lane i of block b, words = (block_count + 3) / 4.
    void (*filter_flat)(const SurfaceBlock* blocks, std::uint32_t block_count, const LineBatch& batch,
                        const std::uint32_t* numbers, std::size_t count, std::uint64_t* masks);

    /// The same for one line.
    void (*filter_line)(const SurfaceBlock* blocks, std::uint32_t block_count, const FilterLine& line,
                        std::uint64_t* masks);

    /// Visits every block with a surface that the line may meet, in any order.
    void (*visit_all)(const WideNode* nodes, const SurfaceBlock* blocks, const FilterLine& line, VisitBlocks visit,
                      void* context);

    /// The same, nearer blocks first as far as boxes tell, and only as far as `visit` says.
    void (*visit_nearest)(const WideNode* nodes, const SurfaceBlock* blocks, const FilterLine& line, VisitBlock visit,
                          void* context);
};

/// Those that this processor can run, the fastest first; the plain one is always there.
std::vector<const FilterKernel*> available_kernels();

} // namespace multipath
