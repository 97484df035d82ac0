#pragma once

#include "sampling/warp_kernel.h"

namespace multipath {

// Each in its own file; they are one template (lane_warp.inl) over the Lanes of the instruction set.
extern const WarpKernel plain_warp_kernel;
#if defined(__x86_64__)
extern const WarpKernel sse2_warp_kernel;
extern const WarpKernel avx2_warp_kernel;
extern const WarpKernel avx512_warp_kernel;
#endif

} // namespace multipath
