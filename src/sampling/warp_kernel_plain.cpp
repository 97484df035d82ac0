// The maps in plain C++, for any processor: one point after the other.

#include "sampling/warp_kernels.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#define KERNEL_CODE inline
#define KERNEL_ENTRY

namespace multipath {
namespace {

struct Lanes
{
    static constexpr std::size_t width = 1;
    double x;

    static Lanes load(const double* from) { return {*from}; }
    static Lanes all(double value) { return {value}; }
    void store(double* to) const { *to = x; }
};

KERNEL_CODE Lanes operator+(Lanes a, Lanes b)
{
    return {a.x + b.x};
}
KERNEL_CODE Lanes operator-(Lanes a, Lanes b)
{
    return {a.x - b.x};
}
KERNEL_CODE Lanes operator*(Lanes a, Lanes b)
{
    return {a.x * b.x};
}
KERNEL_CODE Lanes square_root(Lanes a)
{
    return {std::sqrt(a.x)};
}
/// a < b ? yes : no
KERNEL_CODE Lanes choose_less(Lanes a, Lanes b, Lanes yes, Lanes no)
{
    return a.x < b.x ? yes : no;
}
KERNEL_CODE std::uint64_t bits_of(Lanes a)
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &a.x, sizeof bits);
    return bits;
}
/// -0 where this bit of the number's representation is set, else 0.
template <int bit>
KERNEL_CODE Lanes sign_from_bit(Lanes a)
{
    return {(bits_of(a) >> bit & 1) != 0 ? -0.0 : 0.0};
}
/// yes where the sign is negative, also that of -0.
KERNEL_CODE Lanes choose_by_sign(Lanes sign, Lanes yes, Lanes no)
{
    return std::signbit(sign.x) ? yes : no;
}
/// -a where the sign is negative.
KERNEL_CODE Lanes with_sign(Lanes sign, Lanes a)
{
    return {std::signbit(sign.x) ? -a.x : a.x};
}

} // namespace
} // namespace multipath

#include "sampling/lane_warp.inl"

namespace multipath {

const WarpKernel plain_warp_kernel = {"plain", uniform_sphere, cosine_hemisphere};

} // namespace multipath
