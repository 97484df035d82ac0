#include "transport/exchange/kernels/row_kernel.h"

#include "parallel/instruction_set.h"

namespace multipath {

std::vector<const RowKernel*> available_row_kernels()
{
    std::vector<const RowKernel*> kernels;
#if defined(__x86_64__)
    if (usable(InstructionSet::avx512))
        kernels.push_back(&avx512_row_kernel);
    if (usable(InstructionSet::avx2))
        kernels.push_back(&avx2_row_kernel);
    if (usable(InstructionSet::sse2))
        kernels.push_back(&sse2_row_kernel);
#endif
    kernels.push_back(&plain_row_kernel);
    return kernels;
}

} // namespace multipath
