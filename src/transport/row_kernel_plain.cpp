// Rows times vectors in plain C++, for any processor.

#include "parallel/double_lanes_plain.h"
#include "transport/row_kernels.h"

#include "transport/lane_row.inl"

namespace multipath {

const RowKernel plain_row_kernel = {"plain", multiply_row<1>, multiply_row<3>};

} // namespace multipath
