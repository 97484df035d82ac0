// The maps of warp.h for many points. Compilers turn these loops into vector code of the instruction set, which is faster
// than a loop for every processor by the width of its registers. This file is included once for each instruction set.

namespace multipath {
namespace LANE_SET {
namespace {

KERNEL_ENTRY void uniform_sphere(const Item* items, std::size_t count, std::size_t first_number, WarpedPoints& points)
{
    for (std::size_t k = 0; k < count; ++k)
        points.set(k, square_to_uniform_sphere(items[k][first_number], items[k][first_number + 1]));
}

KERNEL_ENTRY void cosine_hemisphere(const Item* items, std::size_t count, std::size_t first_number, WarpedPoints& points)
{
    for (std::size_t k = 0; k < count; ++k)
        points.set(k, square_to_cosine_hemisphere(items[k][first_number], items[k][first_number + 1]));
}

constexpr WarpKernel table = {LANE_SET_NAME, uniform_sphere, cosine_hemisphere};

} // namespace
} // namespace LANE_SET
} // namespace multipath
