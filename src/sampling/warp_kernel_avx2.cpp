// The maps for x86-64 processors with AVX2: 4 points at a time.

#include "sampling/warp_kernel.h"

#if defined(__x86_64__)

#include "parallel/double_lanes_avx2.h"

#include "sampling/lane_warp.inl"

namespace multipath {

const WarpKernel avx2_warp_kernel = {"avx2", uniform_sphere, cosine_hemisphere};

} // namespace multipath

#endif
