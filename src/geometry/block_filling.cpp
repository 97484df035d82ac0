// How much slack the tests of SurfaceBlock need. They must pass every line that SurfaceTable::decide, in double
// precision, lets pass. Let e = 2^-24 be the rounding error of single precision, r = 1 the half diagonal of the box, L
// the length of the line's direction D, M its moment, n the unit normal, U = 2 r to_u the gradient of u (from -1 to 1)
// and m = max(|U|, |V|). All surfaces and the part of the line near them lie in the unit sphere, so
//     |M| <= L,  |u_moment| = |U x n| <= m,  |u_direction| = |u_0 n + offset U| <= 2 m,  |offset| <= 1,
// since u vanishes in the sphere (|u_0| <= m).
//
// 1. u a is a sum of six products of rounded factors: 2 e for the factors of each, at most 7 e for the product and the
//    additions it takes part in, fused or not: 9 e (m L + 2 m L) = 27 m e L. The approach a: 6 e L. |a| + slack L: e L.
// 2. Double precision: the line begins at most 10^7 r from the origin and the box (FilterFrame::reach), where u, the
//    plane's distance and the moment lose less than 10^-8 (m + 1) L < e/4 (m + 1) L each, the four together e (m + 1)
//    L. Nothing is said of the sign of a, which rounding can turn when a line lies in the plane: |u a| <= |a| needs
//    none. In all |u a| exceeds |a| by at most 28 m e L + 8 e L < 32 (m + 1) e L: the slack.
// 3. The diagonal of a triangle: (u a + v a) sign(a) is wrong by twice that when the sign is right. When it is wrong, a
//    is mere rounding, |a| < 8 e L, and |u a|, |v a| passed by double precision are no larger than it: again twice the
//    slack is enough.
// 4. The distance h = offset - dot(n, middle), |middle| < 1.5: (2 + 4) e (1 + 1.5) = 15 e, and |a| half_length, at most
//    1.01, 10 e: below 32 e. The double precision result passes |h| <= |a| half_length: what it meets lies in the box,
//    and the line was cut outside of it.
//
// Where the row itself describes the surface badly (slivers), what passes may lie beside the surface: that is what
// can_be_filtered excludes. Boxes around surfaces have 2 coplanar_distance of the diagonal to spare, that is 2e-5 r;
// the row takes 1.4e-5 r of it, 1e-5 r for surfaces moved to a shared plane, and the boxes' own rounding 2e-6 r.

#include "geometry/block_filling.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr double slack_per_gradient = 32.0 * 0x1p-24;
constexpr double displacement_limit = 1.4e-5; // [r]
constexpr double gradient_limit = 1e12;       // [1/r] keeps products of single precision finite

void put(float (&vector)[3][SurfaceBlock::lanes], unsigned lane, Vec3 value)
{
    vector[0][lane] = static_cast<float>(value.x);
    vector[1][lane] = static_cast<float>(value.y);
    vector[2][lane] = static_cast<float>(value.z);
}

} // namespace

SurfaceBlock empty_block()
{
    SurfaceBlock block{};
    std::fill(std::begin(block.diagonal), std::end(block.diagonal), SurfaceBlock::no_diagonal);
    std::fill(std::begin(block.slack), std::end(block.slack), -1.0f);
    return block;
}

void fill_lane(SurfaceBlock& block, unsigned lane, const SurfaceRow& row, const FilterFrame& frame)
{
    const Vec3 normal = row.vector(0);
    const double offset = frame.scale() * (row.offset[0] - dot(normal, frame.centre()));
    put(block.normal, lane, normal);
    block.offset[lane] = static_cast<float>(offset);
    double steepest = 0.0;
    const auto put_coordinate = [&](std::size_t i, auto& moment, auto& direction) {
        const Vec3 gradient = 2.0 * frame.radius() * row.vector(i);
        const double at_centre = 2.0 * (dot(row.vector(i), frame.centre()) + row.offset[i]) - 1.0;
        put(moment, lane, cross(gradient, normal));
        put(direction, lane, at_centre * normal + offset * gradient);
        steepest = std::max(steepest, length(gradient));
    };
    put_coordinate(1, block.u_moment, block.u_direction);
    put_coordinate(2, block.v_moment, block.v_direction);
    const double slack = slack_per_gradient * (1.0 + steepest);
    block.slack[lane] = static_cast<float>(slack);
    const bool is_triangle = row.offset[3] > 0.0;
    block.diagonal[lane] = is_triangle ? static_cast<float>(2.0 * slack) : SurfaceBlock::no_diagonal;
}

// The point where the row has given plane distance, u and v solves three linear equations; its distance from the corner
// that should be there, by Cramer's rule, once for the rounding of the row and once for that of its use.
bool can_be_filtered(const SurfaceRow& row, const Surface& surface, const FilterFrame& frame)
{
    const Vec3 normal = row.vector(0);
    const Vec3 to_u = row.vector(1);
    const Vec3 to_v = row.vector(2);
    const double u_steepness = length(to_u);
    const double v_steepness = length(to_v);
    const double steepest = frame.radius() * std::max(u_steepness, v_steepness);
    const double determinant = std::abs(dot(normal, cross(to_u, to_v)));
    const double rounding = 1e-15 * frame.reach() * frame.radius();
    const auto displacement = [&](double u, double v) {
        const Vec3 corner = surface.at(u, v);
        const double beside_plane = std::abs(dot(normal, corner) - row.offset[0]) + rounding;
        const double u_error = std::abs(dot(to_u, corner) + row.offset[1] - u) + rounding * u_steepness;
        const double v_error = std::abs(dot(to_v, corner) + row.offset[2] - v) + rounding * v_steepness;
        return (beside_plane * length(cross(to_u, to_v)) + u_error * v_steepness + v_error * u_steepness) / determinant;
    };
    const double limit = displacement_limit * frame.radius();
    return steepest < gradient_limit && displacement(0.0, 0.0) < limit && displacement(1.0, 0.0) < limit &&
           displacement(0.0, 1.0) < limit;
}

} // namespace multipath
