#pragma once

#include "sampling/sequence.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// Largest number of points that one call of a kernel maps. Arrays of this size stay in the first-level cache.
constexpr std::size_t warp_block = 256;

/// Points of space, as one array per coordinate.
struct WarpedPoints
{
    alignas(64) double x[warp_block];
    alignas(64) double y[warp_block];
    alignas(64) double z[warp_block];
};

/// Points of the unit square, as one array per coordinate.
struct SquarePoints
{
    alignas(64) double a[warp_block];
    alignas(64) double b[warp_block];
};

/// Copies the coordinates first_number and first_number + 1 of `count` <= warp_block items into `square`. Sets the
/// points from `count` up to the next multiple of 8 to 0, since kernels read them too.
void load_square_points(const Item* items, std::size_t count, std::size_t first_number, SquarePoints& square);

/// Maps of warp.h for `count` <= warp_block points per call, compiled for one instruction set. All kernels give the
/// same bits as square_to_uniform_sphere and square_to_cosine_hemisphere for single points. A kernel processes groups
/// of up to 8 points: if `count` is not a multiple of 8, it may read and write elements up to the next multiple.
struct WarpKernel
{
    const char* name; ///< name of the instruction set

    void (*uniform_sphere)(const SquarePoints& square, std::size_t count, WarpedPoints& points);
    void (*cosine_hemisphere)(const SquarePoints& square, std::size_t count, WarpedPoints& points);
};

/// The kernels whose instruction set is usable (see parallel/instruction_set.h), fastest first. The plain C++ kernel is
/// always among them.
std::vector<const WarpKernel*> available_warp_kernels();

/// The fastest of available_warp_kernels().
const WarpKernel& warp_kernel();

} // namespace multipath
