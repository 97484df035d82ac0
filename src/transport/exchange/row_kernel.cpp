#include "transport/exchange/symmetric_product.h"

#include "parallel/instruction_set.h"

#define KERNELS "transport/exchange/lane_row.inl"
#include "parallel/lanes/every_set.inl"

namespace multipath {

std::vector<const RowKernel*> available_row_kernels()
{
    return usable_kernels<RowKernel>({EVERY_TABLE});
}

} // namespace multipath
