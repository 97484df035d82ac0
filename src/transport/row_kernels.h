#pragma once

#include "transport/row_kernel.h"

namespace multipath {

// Each in its own file; they are one template (lane_row.inl) over the lanes of the instruction set.
extern const RowKernel plain_row_kernel;
#if defined(__x86_64__)
extern const RowKernel sse2_row_kernel;
extern const RowKernel avx2_row_kernel;
extern const RowKernel avx512_row_kernel;
#endif

} // namespace multipath
