#pragma once

// One number at a time in plain C++, for any processor; what the functions do is said here.
// To be included by a file of kernels for this instruction set alone: everything is static, so that no code for a
// special processor can be taken for that of the rest of the program. KERNEL_CODE is what functions must carry that are
// expanded in place, KERNEL_ENTRY those that are called.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#define KERNEL_CODE inline
#define KERNEL_ENTRY

namespace multipath {
namespace {

/// Double precision numbers side by side. No multiply is fused with an add, which would round differently.
struct DoubleLanes
{
    static constexpr std::size_t width = 1;
    double x;

    static DoubleLanes load(const double* from) { return {*from}; }
    static DoubleLanes load_floats(const float* from) { return {static_cast<double>(*from)}; }
    static DoubleLanes all(double value) { return {value}; }
    void store(double* to) const { *to = x; }
};

KERNEL_CODE DoubleLanes operator+(DoubleLanes a, DoubleLanes b)
{
    return {a.x + b.x};
}
KERNEL_CODE DoubleLanes operator-(DoubleLanes a, DoubleLanes b)
{
    return {a.x - b.x};
}
KERNEL_CODE DoubleLanes operator*(DoubleLanes a, DoubleLanes b)
{
    return {a.x * b.x};
}
KERNEL_CODE DoubleLanes square_root(DoubleLanes a)
{
    return {std::sqrt(a.x)};
}
/// a < b ? yes : no
KERNEL_CODE DoubleLanes choose_less(DoubleLanes a, DoubleLanes b, DoubleLanes yes, DoubleLanes no)
{
    return a.x < b.x ? yes : no;
}
KERNEL_CODE std::uint64_t bits_of(DoubleLanes a)
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &a.x, sizeof bits);
    return bits;
}
/// -0 where this bit of the number's representation is set, else 0.
template <int bit>
KERNEL_CODE DoubleLanes sign_from_bit(DoubleLanes a)
{
    return {(bits_of(a) >> bit & 1) != 0 ? -0.0 : 0.0};
}
/// yes where the sign is negative, also that of -0.
KERNEL_CODE DoubleLanes choose_by_sign(DoubleLanes sign, DoubleLanes yes, DoubleLanes no)
{
    return std::signbit(sign.x) ? yes : no;
}
/// -a where the sign is negative.
KERNEL_CODE DoubleLanes with_sign(DoubleLanes sign, DoubleLanes a)
{
    return {std::signbit(sign.x) ? -a.x : a.x};
}

} // namespace
} // namespace multipath
