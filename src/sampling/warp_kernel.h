#pragma once

#include "geometry/vec3.h"
#include "sampling/sequence.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// Number of points that callers map at a time: few enough to stay in the first-level cache.
constexpr std::size_t warp_block = 256;

/// Maps of warp.h, compiled for one instruction set: points[k] becomes the map of the coordinates first_number and
/// first_number + 1 of items[k], for k = 0 ... count - 1. All kernels give the same bits as the maps of single points.
struct WarpKernel
{
    using Map = void (*)(const Item* items, std::size_t count, std::size_t first_number, Vec3* points);

    const char* name; ///< name of the instruction set
    Map uniform_sphere;
    Map cosine_hemisphere;
};

/// The kernels whose instruction set is usable (see parallel/instruction_set.h), fastest first. The plain C++ kernel is
/// always among them.
std::vector<const WarpKernel*> available_warp_kernels();

/// The fastest of available_warp_kernels().
const WarpKernel& warp_kernel();

} // namespace multipath
