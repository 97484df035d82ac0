// The six sides of the box are laid beside each other on the unit square, each as wide as its share of the area: the
// four walls as one strip without a seam, then floor and ceiling. All of it is linear, so well-spread numbers give
// well-spread points. A side without area, as the walls of a flat scene have it, has no width. Other layouts measure
// equally good: the directions into the box jump from side to side in any case.

#include "transport/lines/global_lines.h"

#include "geometry/pi.h"
#include "sampling/warp.h"
#include "sampling/warp_kernel.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// Turns the sphere so that its poles and meridians point nowhere in particular: the regular numbers of quasi-random
/// sequences would otherwise send lines exactly along the edges and through the corners of rooms. A rotation about (1,
/// 2, 3) with the cosine 2/7 (Rodrigues' formula).
Vec3 turned(Vec3 p)
{
    constexpr double cosine = 2.0 / 7.0;
    constexpr double sine = 0.95831484749990992;                                           // sqrt(1 - 4/49)
    constexpr Vec3 axis = {0.26726124191242440, 0.53452248382484879, 0.80178372573727319}; // (1, 2, 3) / sqrt 14
    return cosine * p + sine * cross(axis, p) + ((1.0 - cosine) * dot(axis, p)) * axis;
}

/// How far a ray from a point of the box goes inside it.
double way_through(const Bounds& box, Vec3 from, Vec3 direction)
{
    const auto way = [](double low, double high, double at, double slope) {
        return slope == 0.0 ? Bounds::infinity : ((slope > 0.0 ? high : low) - at) / slope;
    };
    const double shortest =
        std::min({way(box.low.x, box.high.x, from.x, direction.x), way(box.low.y, box.high.y, from.y, direction.y),
                  way(box.low.z, box.high.z, from.z, direction.z)});
    return std::max(0.0, shortest); // rounding may put the point a little outside
}

} // namespace

GlobalLines::GlobalLines(const Bounds& scene_box, Chords chords)
    : box_(scene_box), chords_(chords), radius_(0.5 * scene_box.diagonal()), sides_(unrolled(scene_box))
{
}

std::array<GlobalLines::Side, 6> GlobalLines::unrolled(const Bounds& box)
{
    constexpr Vec3 x = {1.0, 0.0, 0.0};
    constexpr Vec3 y = {0.0, 1.0, 0.0};
    constexpr Vec3 z = {0.0, 0.0, 1.0};
    const Vec3 a = box.low;
    const Vec3 b = box.high;
    const Vec3 size = box.size();
    // The cross product of along and up points into the box.
    std::array<Side, 6> sides = {{{a, x, y, size.x, size.y, 0.0},
                                  {{b.x, a.y, a.z}, z, y, size.z, size.y, 0.0},
                                  {{b.x, a.y, b.z}, -x, y, size.x, size.y, 0.0},
                                  {{a.x, a.y, b.z}, -z, y, size.z, size.y, 0.0},
                                  {a, z, x, size.z, size.x, 0.0},
                                  {{a.x, b.y, a.z}, x, z, size.x, size.z, 0.0}}};
    double strip = 0.0;
    for (Side& side : sides)
        side.strip_end = strip += side.width * side.height;
    return sides;
}

Line GlobalLines::line(const Item& item) const
{
    return chords_ == Chords::box ? box_line(item) : sphere_line(item);
}

Line GlobalLines::sphere_line(const Item& item) const
{
    const Vec3 from = box_.centre() + radius_ * turned(square_to_uniform_sphere(item[0], item[1]));
    const Vec3 to = box_.centre() + radius_ * turned(square_to_uniform_sphere(item[2], item[3]));
    return chord(from, to);
}

Line GlobalLines::box_line(const Item& item) const
{
    return box_line(item, square_to_cosine_hemisphere(item[2], item[3]));
}

/// `local`: the direction, with z into the box.
Line GlobalLines::box_line(const Item& item, Vec3 local) const
{
    // A line must not run along an edge of the box, where it could miss both walls.
    const auto inside = [](double share) { return std::clamp(share, 0x1p-30, 1.0 - 0x1p-30); };
    const double strip = item[0] * sides_.back().strip_end;
    std::size_t number = 0; // of the side, without a branch: which one it is cannot be predicted
    for (std::size_t k = 0; k + 1 < sides_.size(); ++k)
        number += strip >= sides_[k].strip_end;
    const Side& side = sides_[number];
    const double area = side.width * side.height;
    const Vec3 place = side.corner + inside(1.0 - (side.strip_end - strip) / area) * side.width * side.along +
                       inside(item[1]) * side.height * side.up;

    // Oblique to the edges (3-4-5 triangle), so that regular numbers do not aim exactly at the edges of rooms.
    const Vec3 normal = cross(side.along, side.up);
    const Vec3 tangent = 0.6 * side.along + 0.8 * side.up;
    const Vec3 direction = local.x * tangent + local.y * cross(normal, tangent) + local.z * normal;

    // The walls of a room lie in the sides of its box: the line begins before and ends beyond them.
    const Vec3 margin = radius_ / 8.0 * direction;
    return chord(place - margin, place + way_through(box_, place, direction) * direction + margin);
}

void GlobalLines::lines(const Item* items, std::size_t count, Line* lines) const
{
    for (std::size_t first = 0; first < count; first += warp_block) {
        const std::size_t size = std::min(warp_block, count - first);
        if (chords_ == Chords::box)
            box_lines(items + first, size, lines + first);
        else
            sphere_lines(items + first, size, lines + first);
    }
}

void GlobalLines::sphere_lines(const Item* items, std::size_t count, Line* lines) const
{
    SquarePoints square = {};
    WarpedPoints from;
    WarpedPoints to;
    take_square(items, count, 0, square);
    warp_kernel().uniform_sphere(square, count, from);
    take_square(items, count, 2, square);
    warp_kernel().uniform_sphere(square, count, to);
    const Vec3 centre = box_.centre();
    for (std::size_t k = 0; k < count; ++k)
        lines[k] = chord(centre + radius_ * turned({from.x[k], from.y[k], from.z[k]}),
                         centre + radius_ * turned({to.x[k], to.y[k], to.z[k]}));
}

void GlobalLines::box_lines(const Item* items, std::size_t count, Line* lines) const
{
    SquarePoints square = {};
    WarpedPoints local;
    take_square(items, count, 2, square);
    warp_kernel().cosine_hemisphere(square, count, local);
    for (std::size_t k = 0; k < count; ++k)
        lines[k] = box_line(items[k], {local.x[k], local.y[k], local.z[k]});
}

std::uint64_t GlobalLines::lines_to_cast(std::uint64_t lines_met) const
{
    // Of the chords that meet the sphere, the share A_box / A_sphere meets the convex box inside it.
    return static_cast<std::uint64_t>(std::llround(static_cast<double>(lines_met) * area_of_starts() / box_.area()));
}

double GlobalLines::expected_crossings(double area, std::uint64_t lines_cast) const
{
    return 2.0 * area / area_of_starts() * static_cast<double>(lines_cast); // (G1)
}

double GlobalLines::area_of_starts() const
{
    return chords_ == Chords::box ? box_.area() : sphere_area();
}

double GlobalLines::sphere_area() const
{
    return 4.0 * pi * radius_ * radius_;
}

} // namespace multipath
