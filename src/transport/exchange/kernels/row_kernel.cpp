#include "transport/exchange/kernels/row_kernel.h"

#include "parallel/instruction_set.h"

#define KERNELS "transport/exchange/kernels/lane_row.inl"
#include "parallel/lanes/every_set.inl"

namespace multipath {

std::vector<const RowKernel*> available_row_kernels()
{
    return usable_kernels<RowKernel>({EVERY_TABLE});
}

} // namespace multipath
