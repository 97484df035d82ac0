#pragma once

#include "geometry/vec3.h"
#include "sampling/sequence.h"

#include <array>
#include <cstddef>
#include <vector>

namespace multipath {

/// Number of points that callers map at a time: few enough to stay in the first-level cache.
constexpr std::size_t warp_block = 256;

/// Points of space, as one array per coordinate, which vector instructions write fastest.
struct WarpedPoints
{
    void set(std::size_t k, Vec3 p)
    {
        x[k] = p.x;
        y[k] = p.y;
        z[k] = p.z;
    }
    Vec3 operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }

    std::array<double, warp_block> x, y, z;
};

/// Maps of warp.h, compiled for one instruction set: points[k] becomes the map of the coordinates first_number and
/// first_number + 1 of items[k], for k = 0 ... count - 1 < warp_block. All kernels give the same bits as the maps of
/// single points.
struct WarpKernel
{
    using Map = void (*)(const Item* items, std::size_t count, std::size_t first_number, WarpedPoints& points);

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
