#pragma once

#include "geometry/pi.h"
#include "sampling/sequence.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// So many points as one call maps at most; arrays of this size stay in the fastest cache.
constexpr std::size_t warp_block = 256;

/// Points of space, coordinate by coordinate.
struct WarpedPoints
{
    alignas(64) double x[warp_block];
    alignas(64) double y[warp_block];
    alignas(64) double z[warp_block];
};

/// Points of the unit square, coordinate by coordinate.
struct SquarePoints
{
    alignas(64) double a[warp_block];
    alignas(64) double b[warp_block];
};

/// Two successive numbers of every item; what fills up the last group of lanes is 0.
void take_square(const Item* items, std::size_t count, std::size_t first_number, SquarePoints& square);

/// The maps of warp.h for many points at a time, compiled for one instruction set. All give the same numbers as the
/// maps for one point, bit for bit. They fill whole groups of lanes: `count` rounded up to the next multiple of 8.
struct WarpKernel
{
    const char* name; ///< of the instruction set

    void (*uniform_sphere)(const SquarePoints& square, std::size_t count, WarpedPoints& points);
    void (*cosine_hemisphere)(const SquarePoints& square, std::size_t count, WarpedPoints& points);
};

/// Those whose instruction set is usable, the fastest first; the plain one is always there.
std::vector<const WarpKernel*> available_warp_kernels();

/// The fastest of them.
const WarpKernel& warp_kernel();

} // namespace multipath
