#include "transport/exchange/kernels/row_kernel.h"

#include "parallel/instruction_set.h"

namespace multipath {

std::vector<const RowKernel*> available_row_kernels()
{
#if defined(__x86_64__)
    return usable_kernels(avx512_row_kernel, avx2_row_kernel, sse2_row_kernel, plain_row_kernel);
#else
    return {&plain_row_kernel};
#endif
}

} // namespace multipath
