#include "geometry/filter_kernel.h"

#include "geometry/filter_kernels.h"

namespace multipath {

std::vector<const FilterKernel*> available_kernels()
{
    std::vector<const FilterKernel*> kernels;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
        kernels.push_back(&avx512_kernel);
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        kernels.push_back(&avx2_kernel);
    kernels.push_back(&sse2_kernel);
#endif
    kernels.push_back(&plain_kernel);
    return kernels;
}

} // namespace multipath
