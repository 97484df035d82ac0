#include "transport/row_kernel.h"

#include "transport/row_kernels.h"

namespace multipath {

std::vector<const RowKernel*> available_row_kernels()
{
    std::vector<const RowKernel*> kernels;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
        kernels.push_back(&avx512_row_kernel);
    if (__builtin_cpu_supports("avx2"))
        kernels.push_back(&avx2_row_kernel);
    kernels.push_back(&sse2_row_kernel);
#endif
    kernels.push_back(&plain_row_kernel);
    return kernels;
}

} // namespace multipath
