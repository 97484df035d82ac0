// The maps of warp.cpp to the sphere and the hemisphere, and the sine and cosine of base/elementary.h, for several
// points at a time: the same operations in the same order, with selections instead of branches. Read warp.cpp first.
// This file is included once for each instruction set; parallel/lanes/plain.inl defines the functions of lanes.

namespace multipath {
namespace LANE_SET {
namespace {

struct LaneSinCos
{
    DoubleLanes sin, cos;
};

/// Sum of coefficients[k] y^k by Horner's rule.
KERNEL_CODE DoubleLanes polynomial(DoubleLanes y, const double* coefficients, int count)
{
    DoubleLanes sum = DoubleLanes::all(coefficients[count - 1]);
    for (int k = count - 2; k >= 0; --k)
        sum = DoubleLanes::all(coefficients[k]) + y * sum;
    return sum;
}

/// The same as sin_cos_of_turns of base/elementary.h. Instead of a conversion to an integer, 2^52 is added, so that
/// the fraction is rounded away; the lowest bits of the sum are then those of the integer.
KERNEL_CODE LaneSinCos sin_cos_of_turns(DoubleLanes turns)
{
    constexpr double sine_terms[] = {1.0,          -1.0 / 6,        1.0 / 120,          -1.0 / 5040,
                                     1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800.0, -1.0 / 1307674368000.0};
    constexpr double cosine_terms[] = {1.0,
                                       -1.0 / 2,
                                       1.0 / 24,
                                       -1.0 / 720,
                                       1.0 / 40320,
                                       -1.0 / 3628800,
                                       1.0 / 479001600,
                                       -1.0 / 87178291200.0,
                                       1.0 / 20922789888000.0};
    const DoubleLanes without_fraction = DoubleLanes::all(0x1.0p52);
    const DoubleLanes above = DoubleLanes::all(4.0) * turns + DoubleLanes::all(0.5);
    const DoubleLanes nearest = (above + without_fraction) - without_fraction;
    const DoubleLanes quarter = choose_less(above, nearest, nearest - DoubleLanes::all(1.0), nearest); // rounded down
    const DoubleLanes rest = turns - DoubleLanes::all(0.25) * quarter;
    const DoubleLanes x = DoubleLanes::all(2.0 * pi) * rest;
    const DoubleLanes y = x * x;
    const DoubleLanes s = x * polynomial(y, sine_terms, 8);
    const DoubleLanes c = polynomial(y, cosine_terms, 9);
    const DoubleLanes bits = quarter + without_fraction;
    const DoubleLanes swap = sign_from_bit<0>(bits);
    return {with_sign(sign_from_bit<1>(bits), choose_by_sign(swap, c, s)),
            with_sign(sign_from_bit<1>(bits + DoubleLanes::all(1.0)), choose_by_sign(swap, s, c))};
}

KERNEL_ENTRY void uniform_sphere(const SquarePoints& square, std::size_t count, WarpedPoints& points)
{
    for (std::size_t k = 0; k < count; k += DoubleLanes::width) {
        const DoubleLanes a = DoubleLanes::load(square.a + k);
        const DoubleLanes radius = DoubleLanes::all(2.0) * square_root(a * (DoubleLanes::all(1.0) - a));
        const LaneSinCos angle = sin_cos_of_turns(DoubleLanes::load(square.b + k));
        (radius * angle.cos).store(points.x + k);
        (radius * angle.sin).store(points.y + k);
        (DoubleLanes::all(1.0) - DoubleLanes::all(2.0) * a).store(points.z + k);
    }
}

KERNEL_ENTRY void cosine_hemisphere(const SquarePoints& square, std::size_t count, WarpedPoints& points)
{
    for (std::size_t k = 0; k < count; k += DoubleLanes::width) {
        const DoubleLanes a = DoubleLanes::load(square.a + k);
        const DoubleLanes radius = square_root(a);
        const LaneSinCos angle = sin_cos_of_turns(DoubleLanes::load(square.b + k));
        (radius * angle.cos).store(points.x + k);
        (radius * angle.sin).store(points.y + k);
        square_root(DoubleLanes::all(1.0) - a).store(points.z + k);
    }
}

constexpr WarpKernel table = {LANE_SET_NAME, uniform_sphere, cosine_hemisphere};

} // namespace
} // namespace LANE_SET
} // namespace multipath
