#include "geometry/intersector/kernel.h"

#include "parallel/instruction_set.h"

namespace multipath {

std::vector<const FilterKernel*> available_kernels()
{
    std::vector<const FilterKernel*> kernels;
#if defined(__x86_64__)
    if (usable(InstructionSet::avx512))
        kernels.push_back(&avx512_kernel);
    if (usable(InstructionSet::avx2))
        kernels.push_back(&avx2_kernel);
    if (usable(InstructionSet::sse2))
        kernels.push_back(&sse2_kernel);
#endif
    kernels.push_back(&plain_kernel);
    return kernels;
}

} // namespace multipath
