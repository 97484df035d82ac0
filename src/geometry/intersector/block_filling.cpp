// Fills the single-precision forms of surfaces and derives the slack of their tests: a filter must pass every line that
// SurfaceTable::decide accepts in double precision. This first note is about SurfaceBlock; one on RectangleFrame
// follows below.
//
// Let e = 2^-24 be the rounding error of single precision, r = 1 the half diagonal of the box, L the length of the
// line's direction D, U and V the edges of a surface, m = max(|U|, |V|) <= 2 and n = cross(U, V), |n| <= |U| |V| <= 2
// m. All surfaces and the segment of the line near them lie in the unit sphere. The vector c from the line's middle to
// the corner is at most 2.5 long and has an error of 5 e: 1 and 1.5 for its ends, 2.5 for the subtraction. The
// arithmetic of a cross product has an error of 2 sqrt(2) e times the lengths of its factors, each rounded factor adds
// e; a sum of three products has 3 e times theirs.
// 1. n: 6 e |U| |V|. a: 6 + 1 + 3 = 10 e |U| |V| L, at most 20 e m L. cross(c, D): 5 + 2.5 + 7.1 < 15 e L; u a and v a:
//    15 + 2.5 + 7.5 = 25 e m L.
// 2. Double precision: the line begins at most 10^7 r from the origin and the box (FilterFrame::reach), where it loses
//    less than e (|gradient of u| + 1) L |n| <= e (2 m + 2 m) L = 4 e m L.
// 3. u a <= |a|: 25 + 20, and 3 for the sum |a| + slack L. (u + v) a <= |a|: 50 + 20 + 4 + 3, with 4 for the sum, and
//    twice the 4 of double precision: 85 e m L. If the sign of a is wrong, |a| <= 20 e m L, and so are u a and v a,
//    whose sum then has an error of at most 20 + 50 + 4 e m L either way. So 96 e m L.
// 4. t a = dot(n, c): 15 + 5 + 7.5 = 27.5 e |U| |V|. |a| times the ends of the segment, at most 1.01 / L: 10 e |U| |V|
//    for a, 4 for the ends and the multiplication, 1 for double precision: less than 48 e |U| |V| <= 96 e m. So
//    (t a - 96 e m) / |a| is not above the t of a hit.
// So a line certainly meets a surface if it passes these tests with the slack on the other side; what double precision
// loses is part of the sums. The start of a ray may be 1.4e-5 from the plane in the row of its surface
// (displacement_limit): for surfaces in this plane t a is at most 1.4e-5 |n| + 48 e |U| |V|, below 6 times the slack of
// 96 e m since |n| <= 2 m. Corner and edges are computed from the row, as the basis dual to its three gradients, and
// not from the surface, so that the filter tests the same figure as SurfaceTable::decide. If can_be_filtered is true,
// double precision loses much less than e with them.
//
// If the row itself describes the surface badly (slivers), hits may lie off the surface. can_be_filtered excludes such
// surfaces. Boxes around surfaces have a margin of 2 coplanar_distance times the diagonal, which is 2e-5 r. The row
// uses up 1.4e-5 r of it, of which 1e-5 r for surfaces moved to a shared plane, and the rounding of the boxes 2e-6 r.

#include "geometry/intersector/block_filling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace multipath {

namespace {

constexpr double displacement_limit = 1.4e-5; // [r], see the note above
constexpr double gradient_limit = 1e12;       // [1/r] keeps products in single precision finite

/// Stores a vector in one lane.
void put(float (&vector)[3][SurfaceBlock::lanes], std::size_t lane, Vec3 value)
{
    vector[0][lane] = static_cast<float>(value.x);
    vector[1][lane] = static_cast<float>(value.y);
    vector[2][lane] = static_cast<float>(value.z);
}

} // namespace

SurfaceBlock block_of(const SurfaceTable& table, const std::uint32_t* surfaces, std::size_t count,
                      const FilterFrame& frame)
{
    constexpr double slack_per_edge = 96.0 * 0x1p-24;
    SurfaceBlock block{};
    std::fill(std::begin(block.slack), std::end(block.slack), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t lane = 0; lane < count; ++lane) {
        const SurfaceRow& row = table.row(surfaces[lane]);
        const Vec3 normal = row.vector(0);
        const Vec3 to_u = row.vector(1);
        const Vec3 to_v = row.vector(2);
        const double scale = frame.scale() / dot(normal, cross(to_u, to_v));
        const Vec3 edge_u = scale * cross(to_v, normal);
        const Vec3 edge_v = scale * cross(normal, to_u);
        const double height = row.offset[0] - dot(normal, frame.centre());
        const double u_at_centre = dot(to_u, frame.centre()) + row.offset[1];
        const double v_at_centre = dot(to_v, frame.centre()) + row.offset[2];
        const Vec3 corner = height * scale * cross(to_u, to_v) - u_at_centre * edge_u - v_at_centre * edge_v;
        put(block.corner, lane, corner);
        put(block.edge_u, lane, edge_u);
        put(block.edge_v, lane, edge_v);
        const double slack = slack_per_edge * std::max(length(edge_u), length(edge_v));
        block.slack[lane] = static_cast<float>(table.is_triangle(surfaces[lane]) ? -slack : slack);
        block.surface[lane] = surfaces[lane];
    }
    return block;
}

// Bounds the displacement of three corners. The point with given plane distance, u and v solves three linear equations
// with the coefficients of the row. Cramer's rule turns their residuals at the true corner, plus the rounding errors
// when the row is used, into a distance.
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

// Slack of the tests of RectangleFrame, in the terms of the first note. A rectangle is accepted into a frame if its
// normal and its edges differ from the axes by no more than the tolerance T = 1e-5.
//
// First without division by a: u a = (m - centre) a + h d must not exceed half |a|.
// 1. Rounding: a component of the direction has an error of at most 6 e L, one of the middle (|m| < 1.5) 9 e, h 13 e,
//    m - centre (at most 2.5) 13 e; so (m - centre) a + h d has 2 (2.5 * 6 + 13) e L = 56 e L; the limit has 8 e L.
// 2. Tolerance: a and d differ by T L, h and m by 1.5 T: 2 (2.5 + 1.5) T L = 8 T L; the limit differs by T L. In total
//    64 e L + 9 T L < 10 T L.
// 3. |h| <= |a| half_length, and h = a t for the exact t: 13 e + 10 e + 1.5 T + 1.01 T < 4 T.
// None of these depends on the sign of a, which rounding may flip.
//
// Then divided by |a|, if |a| is at least A = 1e-6 S (least_approach), with S = LineBatch::scale between L and 2 L.
// 4. The reciprocal has the relative error R <= 2^-11. t = h / a with |h| < 2.6 has the errors 2.6 R / |a| and, from
//    its operations, 3 e / |a|; in total, with 3., less than (4e-5 + 2.6 R) / |a| (1 + R) < (5e-5 + 3 R) / |a|: the
//    distance slack.
// 5. So t d adds 2.6 R L / |a| to 10 T L / |a|, and the operations add 10 e L / |a|: together less than (1.1e-4 + 3 R)
//    L / |a|: the slack.
// 6. If |a| < A, A replaces |a|. Hits accepted in double precision have |h| <= |a| half_length + 4 T, below 1.01
//    A / L + 4 T. So |t| is at most half_length + 4 T / A and exceeds the exact t by at most 2 half_length + 4 T / A,
//    2.02 A / L being below 4.1e-6. And |u| < 2.5 + (1.01 A / L + 4 T) L / A < 44 is less than the slack of 1.1e-4
//    S / A > 100.

namespace {

constexpr double edge_tolerance = 1e-5; ///< T

/// The points q with |dot(along, q) - centre| <= half, in the coordinates of FilterFrame.
struct Slab
{
    Vec3 along; ///< unit vector
    double centre;
    double half;
};

using Axes = std::array<Vec3, 3>;

/// The slabs whose intersection is a parallelogram: its plane, then those between opposite edges.
std::array<Slab, 3> slabs_of(const SurfaceRow& row, const FilterFrame& frame)
{
    const auto between_edges = [&](std::size_t i) {
        const Vec3 gradient = frame.radius() * row.vector(i);
        const double at_centre = dot(row.vector(i), frame.centre()) + row.offset[i];
        const double steepness = length(gradient);
        return Slab{(1.0 / steepness) * gradient, (0.5 - at_centre) / steepness, 0.5 / steepness};
    };
    const Vec3 normal = row.vector(0);
    return {Slab{normal, frame.scale() * (row.offset[0] - dot(normal, frame.centre())), 0.0}, between_edges(1),
            between_edges(2)};
}

/// A rectangle in terms of the axes of a frame.
struct FittedRectangle
{
    std::size_t axis; ///< of its normal
    FrameRectangle rectangle;
};

/// The parallelogram in terms of the axes, if normal and edges are parallel to them.
std::optional<FittedRectangle> fit_to(const Axes& axes, const std::array<Slab, 3>& slabs)
{
    std::array<std::optional<Slab>, 3> across; // the slab of each axis
    std::size_t axis = 0;                      // of the normal
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const double sign = dot(slabs[i].along, axes[k]) < 0.0 ? -1.0 : 1.0;
            if (length(slabs[i].along - sign * axes[k]) > edge_tolerance)
                continue;
            across[k] = {axes[k], sign * slabs[i].centre, slabs[i].half};
            axis = i == 0 ? k : axis;
        }
    if (!across[0] || !across[1] || !across[2])
        return std::nullopt;
    const Slab& u = *across[(axis + 1) % 3];
    const Slab& v = *across[(axis + 2) % 3];
    return FittedRectangle{axis,
                           {static_cast<float>(across[axis]->centre), static_cast<float>(u.centre),
                            static_cast<float>(v.centre), static_cast<float>(u.half), static_cast<float>(v.half)}};
}

/// The rectangles of one frame, by the axis of their normal, each with the index of its surface.
struct FrameGroup
{
    Axes axes;
    std::array<std::vector<std::pair<FrameRectangle, std::uint32_t>>, 3> across;
};

RectangleFrame frame_with(const Axes& axes)
{
    RectangleFrame frame{};
    for (std::size_t k = 0; k < 3; ++k) {
        frame.axis[k][0] = static_cast<float>(axes[k].x);
        frame.axis[k][1] = static_cast<float>(axes[k].y);
        frame.axis[k][2] = static_cast<float>(axes[k].z);
    }
    return frame;
}

} // namespace

FramedRectangles group_by_frames(const SurfaceTable& table, const std::vector<std::uint32_t>& surfaces,
                                 const FilterFrame& filter_frame)
{
    FramedRectangles result;
    std::vector<FrameGroup> groups;
    for (const std::uint32_t surface : surfaces) {
        if (table.is_triangle(surface)) {
            result.others.push_back(surface);
            continue;
        }
        const std::array<Slab, 3> slabs = slabs_of(table.row(surface), filter_frame);
        std::optional<FittedRectangle> fitted;
        std::size_t g = 0;
        while (g < groups.size() && !(fitted = fit_to(groups[g].axes, slabs)))
            ++g;
        if (!fitted) {
            const Vec3 third = cross(slabs[0].along, slabs[1].along); // along the second edge only of a rectangle
            const Axes own = {slabs[0].along, slabs[1].along, third};
            fitted = fit_to(own, slabs);
            if (!fitted) {
                result.others.push_back(surface);
                continue;
            }
            groups.push_back({own, {}});
        }
        groups[g].across[fitted->axis].push_back({fitted->rectangle, surface});
    }
    for (const FrameGroup& group : groups) {
        result.frames.push_back(frame_with(group.axes));
        for (std::size_t k = 0; k < 3; ++k) {
            for (const auto& [rectangle, surface] : group.across[k]) {
                result.rectangles.push_back(rectangle);
                result.surfaces.push_back(surface);
            }
            result.frames.back().end[k] = static_cast<std::uint32_t>(result.rectangles.size());
        }
    }
    return result;
}

} // namespace multipath
