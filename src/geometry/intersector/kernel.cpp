#include "geometry/intersector/kernel.h"

#include "geometry/conditions.h"
#include "parallel/instruction_set.h"

#define KERNELS "geometry/intersector/kernels/filter_kernel.inl"
#include "parallel/lanes/every_set.inl"

namespace multipath {

std::vector<const FilterKernel*> available_kernels()
{
    return usable_kernels<FilterKernel>({EVERY_TABLE});
}

} // namespace multipath
