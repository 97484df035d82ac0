#include "sampling/warp_kernel.h"

#include "parallel/instruction_set.h"

namespace multipath {

void take_square(const Item* items, std::size_t count, std::size_t first_number, SquarePoints& square)
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
#if defined(__x86_64__)
    return usable_kernels(avx512_warp_kernel, avx2_warp_kernel, sse2_warp_kernel, plain_warp_kernel);
#else
    return {&plain_warp_kernel};
#endif
}

namespace {

const WarpKernel& fastest = *available_warp_kernels().front();

} // namespace

const WarpKernel& warp_kernel()
{
    return fastest;
}

} // namespace multipath
