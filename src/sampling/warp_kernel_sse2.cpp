// The maps for every x86-64 processor: 2 points at a time.

#include "sampling/warp_kernel.h"

#if defined(__x86_64__)

#include "parallel/double_lanes_sse2.h"

#include "sampling/lane_warp.inl"

namespace multipath {

const WarpKernel sse2_warp_kernel = {"sse2", uniform_sphere, cosine_hemisphere};

} // namespace multipath

#endif
