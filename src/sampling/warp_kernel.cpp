#include "sampling/warp_kernel.h"

#include "parallel/instruction_set.h"
#include "sampling/warp.h"

#define KERNELS "sampling/lane_warp.inl"
#include "parallel/lanes/every_set.inl"

namespace multipath {

std::vector<const WarpKernel*> available_warp_kernels()
{
    return usable_kernels<WarpKernel>({EVERY_TABLE});
}

namespace {

const WarpKernel& fastest = *available_warp_kernels().front();

} // namespace

const WarpKernel& warp_kernel()
{
    return fastest;
}

} // namespace multipath
