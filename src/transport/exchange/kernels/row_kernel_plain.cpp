// Rows times vectors in plain C++, for any processor.

#include "parallel/double_lanes_plain.h"
#include "transport/exchange/kernels/row_kernel.h"

#include "transport/exchange/kernels/lane_row.inl"

namespace multipath {

const RowKernel plain_row_kernel = {"plain", multiply_row<1>, multiply_row<3>};

} // namespace multipath
