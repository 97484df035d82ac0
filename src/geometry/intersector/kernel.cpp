#include "geometry/intersector/kernel.h"

#include "parallel/instruction_set.h"

namespace multipath {

std::vector<const FilterKernel*> available_kernels()
{
#if defined(__x86_64__)
    return usable_kernels(avx512_kernel, avx2_kernel, sse2_kernel, plain_kernel);
#else
    return {&plain_kernel};
#endif
}

} // namespace multipath
