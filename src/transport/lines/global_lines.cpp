// Global lines by (G1). Chords of the sphere connect two independent uniform points. Lines from the box start at a
// uniform point of its surface in a cosine-distributed direction: the same density of lines, but none of them misses
// the box.
//
// A uniform point of the box comes from a uniform point of the unit square. The six sides are laid out beside each
// other on the square, each as wide as its share of the area: the four walls as one strip without a seam, then floor
// and ceiling. The map is linear on each side, so low-discrepancy points stay well spread. A side without area, like
// the walls of a flat scene, gets no width. Other layouts were no better: the directions jump from side to side in any
// case.

#include "transport/lines/global_lines.h"

#include "sampling/warp_kernel.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// Rotates the sphere about (1, 2, 3) by the angle of cosine 2/7 (Rodrigues' formula), so that its poles and meridians
/// have no special direction. Otherwise the regular numbers of quasi-random sequences would send lines exactly along
/// the edges and through the corners of rooms.
Vec3 rotated(Vec3 p)
{
    constexpr double cosine = 2.0 / 7.0;
    constexpr double sine = 0.95831484749990992;                                           // sqrt(1 - 4/49)
    constexpr Vec3 axis = {0.26726124191242440, 0.53452248382484879, 0.80178372573727319}; // (1, 2, 3) / sqrt 14
    return cosine * p + sine * cross(axis, p) + ((1.0 - cosine) * dot(axis, p)) * axis;
}

/// Ray parameter at which a ray from a point of the box leaves it.
double exit_distance(const Bounds& box, Vec3 from, Vec3 direction)
{
    const auto to_exit = [](double low, double high, double at, double slope) {
        return slope == 0.0 ? Bounds::infinity : ((slope > 0.0 ? high : low) - at) / slope;
    };
    const double shortest = std::min({to_exit(box.low.x, box.high.x, from.x, direction.x),
                                      to_exit(box.low.y, box.high.y, from.y, direction.y),
                                      to_exit(box.low.z, box.high.z, from.z, direction.z)});
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
    Line result;
    lines(&item, 1, &result);
    return result;
}

/// The line of an item, given its direction `local` in the frame of the side, with +z into the box.
Line GlobalLines::box_line(const Item& item, Vec3 local) const
{
    // A line must not start on an edge of the box: it could run along the edge and miss both walls.
    const auto inside = [](double share) { return std::clamp(share, 0x1p-30, 1.0 - 0x1p-30); };
    const double strip = item[0] * sides_.back().strip_end;
    std::size_t number = 0; // of the side; branchless, since a branch could not be predicted
    for (std::size_t k = 0; k + 1 < sides_.size(); ++k)
        number += strip >= sides_[k].strip_end;
    const Side& side = sides_[number];
    const double area = side.width * side.height;
    const Vec3 point = side.corner + inside(1.0 - (side.strip_end - strip) / area) * side.width * side.along +
                       inside(item[1]) * side.height * side.up;

    // The tangent is oblique to the edges (3-4-5 triangle), so that regular numbers do not aim exactly at the edges of
    // rooms.
    const Vec3 normal = cross(side.along, side.up);
    const Vec3 tangent = 0.6 * side.along + 0.8 * side.up;
    const Vec3 direction = local.x * tangent + local.y * cross(normal, tangent) + local.z * normal;

    // The walls of a room lie in the sides of its box, so the line begins before and ends after the box.
    const Vec3 margin = radius_ / 8.0 * direction;
    return chord(point - margin, point + exit_distance(box_, point, direction) * direction + margin);
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
    WarpedPoints from;
    WarpedPoints to;
    warp_kernel().uniform_sphere(items, count, 0, from);
    warp_kernel().uniform_sphere(items, count, 2, to);
    const Vec3 centre = box_.centre();
    for (std::size_t k = 0; k < count; ++k)
        lines[k] = chord(centre + radius_ * rotated(from[k]), centre + radius_ * rotated(to[k]));
}

void GlobalLines::box_lines(const Item* items, std::size_t count, Line* lines) const
{
    WarpedPoints local;
    warp_kernel().cosine_hemisphere(items, count, 2, local);
    for (std::size_t k = 0; k < count; ++k)
        lines[k] = box_line(items[k], local[k]);
}

std::uint64_t GlobalLines::lines_to_cast(std::uint64_t lines_met) const
{
    // The share A_box / A_sphere of the chords of a sphere meets the convex box inside it; all lines from the box meet
    // it.
    return static_cast<std::uint64_t>(std::llround(static_cast<double>(lines_met) * area_of_starts() / box_.area()));
}

double GlobalLines::expected_crossings(double area, std::uint64_t lines_cast) const
{
    return 2.0 * area / area_of_starts() * static_cast<double>(lines_cast); // (G1)
}

} // namespace multipath
