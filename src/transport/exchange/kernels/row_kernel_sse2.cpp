// Rows times vectors: two numbers at a time, for every x86-64 processor.

#include "transport/exchange/kernels/row_kernel.h"

#if defined(__x86_64__)

#include "parallel/double_lanes_sse2.h"

#include "transport/exchange/kernels/lane_row.inl"

namespace multipath {

const RowKernel sse2_row_kernel = {"sse2", multiply_row<1>, multiply_row<3>};

} // namespace multipath

#endif
