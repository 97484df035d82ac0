// Rows times vectors: four numbers at a time, for x86-64 processors with AVX2.

#include "transport/exchange/kernels/row_kernel.h"

#if defined(__x86_64__)

#include "parallel/double_lanes_avx2.h"

#include "transport/exchange/kernels/lane_row.inl"

namespace multipath {

const RowKernel avx2_row_kernel = {"avx2", multiply_row<1>, multiply_row<3>};

} // namespace multipath

#endif
