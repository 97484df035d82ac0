#include "sampling/warp_kernel.h"

#include "base/elementary.h"
#include "parallel/instruction_set.h"

#define KERNELS "sampling/lane_warp.inl"
#include "parallel/lanes/every_set.inl"

namespace multipath {

void load_square_points(const Item* items, std::size_t count, std::size_t first_number, SquarePoints& square)
{
    for (std::size_t k = 0; k < count; ++k) {
        square.a[k] = items[k][first_number];
        square.b[k] = items[k][first_number + 1];
    }
    for (std::size_t k = count; k % 8 != 0; ++k)
        square.a[k] = square.b[k] = 0.0;
}

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
