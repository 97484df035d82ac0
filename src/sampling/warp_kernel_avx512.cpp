// The maps for x86-64 processors with AVX-512: 8 points at a time.

#include "sampling/warp_kernel.h"

#if defined(__x86_64__)

#include "parallel/double_lanes_avx512.h"

#include "sampling/lane_warp.inl"

namespace multipath {

const WarpKernel avx512_warp_kernel = {"avx512", uniform_sphere, cosine_hemisphere};

} // namespace multipath

#endif
