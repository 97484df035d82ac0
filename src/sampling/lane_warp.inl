// The maps of warp.cpp and the sine and cosine of trigonometry.h, several points at a time, for one instruction set: the
// same operations in the same order, with choices between results for branches. To be included once by the file of each
// instruction set, after
//   KERNEL_CODE   what functions must carry: the instruction set, for these functions alone, and to be expanded in place
//   KERNEL_ENTRY  the same for functions that are called
//   Lanes         that many doubles side by side, with the functions used below
// All is static, so that no code for a special processor can be taken for that of the rest of the program. No multiply
// is fused with an add: that would round differently.
//
// warp.cpp is the version to read first, warp_kernel_plain.cpp tells what the functions of Lanes do.

namespace multipath {
namespace {

struct LaneSinCos
{
    Lanes sin, cos;
};

KERNEL_CODE Lanes polynomial(Lanes y, const double* coefficients, int count)
{
    Lanes sum = Lanes::all(coefficients[count - 1]);
    for (int k = count - 2; k >= 0; --k)
        sum = Lanes::all(coefficients[k]) + y * sum;
    return sum;
}

/// sin_cos_of_turns. The conversion to a whole number and back is replaced by adding so large a number that digits
/// behind the point are rounded away; the sum's lowest bits are then those of the whole number.
KERNEL_CODE LaneSinCos sin_cos_of_turns(Lanes turns)
{
    constexpr double sine_terms[] = {1.0,
                                     -1.0 / 6,
                                     1.0 / 120,
                                     -1.0 / 5040,
                                     1.0 / 362880,
                                     -1.0 / 39916800,
                                     1.0 / 6227020800.0,
                                     -1.0 / 1307674368000.0};
    constexpr double cosine_terms[] = {1.0,
                                       -1.0 / 2,
                                       1.0 / 24,
                                       -1.0 / 720,
                                       1.0 / 40320,
                                       -1.0 / 3628800,
                                       1.0 / 479001600,
                                       -1.0 / 87178291200.0,
                                       1.0 / 20922789888000.0};
    const Lanes without_fraction = Lanes::all(0x1.0p52);
    const Lanes above = Lanes::all(4.0) * turns + Lanes::all(0.5);
    const Lanes nearest = (above + without_fraction) - without_fraction;
    const Lanes quarter = choose_less(above, nearest, nearest - Lanes::all(1.0), nearest); // rounded down
    const Lanes rest = turns - Lanes::all(0.25) * quarter;
    const Lanes x = Lanes::all(6.283185307179586476925) * rest;
    const Lanes y = x * x;
    const Lanes s = x * polynomial(y, sine_terms, 8);
    const Lanes c = polynomial(y, cosine_terms, 9);
    const Lanes bits = quarter + without_fraction;
    const Lanes swap = sign_from_bit<0>(bits);
    return {with_sign(sign_from_bit<1>(bits), choose_by_sign(swap, c, s)),
            with_sign(sign_from_bit<1>(bits + Lanes::all(1.0)), choose_by_sign(swap, s, c))};
}

KERNEL_ENTRY void uniform_sphere(const SquarePoints& square, std::size_t count, WarpedPoints& points)
{
    for (std::size_t k = 0; k < count; k += Lanes::width) {
        const Lanes a = Lanes::load(square.a + k);
        const Lanes radius = Lanes::all(2.0) * square_root(a * (Lanes::all(1.0) - a));
        const LaneSinCos angle = sin_cos_of_turns(Lanes::load(square.b + k));
        (radius * angle.cos).store(points.x + k);
        (radius * angle.sin).store(points.y + k);
        (Lanes::all(1.0) - Lanes::all(2.0) * a).store(points.z + k);
    }
}

KERNEL_ENTRY void cosine_hemisphere(const SquarePoints& square, std::size_t count, WarpedPoints& points)
{
    for (std::size_t k = 0; k < count; k += Lanes::width) {
        const Lanes a = Lanes::load(square.a + k);
        const Lanes radius = square_root(a);
        const LaneSinCos angle = sin_cos_of_turns(Lanes::load(square.b + k));
        (radius * angle.cos).store(points.x + k);
        (radius * angle.sin).store(points.y + k);
        square_root(Lanes::all(1.0) - a).store(points.z + k);
    }
}

} // namespace
} // namespace multipath
