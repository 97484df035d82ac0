#pragma once

#include "geometry/filter_kernel.h"

namespace multipath {

// Each in its own file; they are one source (lane_*.inl) over the Lanes of the instruction set.
extern const FilterKernel plain_kernel;
#if defined(__x86_64__)
extern const FilterKernel sse2_kernel;
extern const FilterKernel avx2_kernel;
extern const FilterKernel avx512_kernel;
#endif

} // namespace multipath
