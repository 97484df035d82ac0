#include "transport/line_sampling.h"

#include "sampling/warp.h"

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

} // namespace

GlobalLines::GlobalLines(const Bounds& scene_box)
    : centre_(scene_box.centre()), radius_(0.5 * scene_box.diagonal()), box_area_(scene_box.area())
{
}

Line GlobalLines::line(const Item& item) const
{
    const Vec3 from = centre_ + radius_ * turned(square_to_uniform_sphere(item[0], item[1]));
    const Vec3 to = centre_ + radius_ * turned(square_to_uniform_sphere(item[2], item[3]));
    return chord(from, to);
}

std::uint64_t GlobalLines::lines_to_cast(std::uint64_t lines_met) const
{
    // Of the chords that meet the sphere, the share A_box / A_sphere meets the convex box inside it.
    return static_cast<std::uint64_t>(std::llround(static_cast<double>(lines_met) * sphere_area() / box_area_));
}

double GlobalLines::expected_crossings(double area, std::uint64_t lines_cast) const
{
    return 2.0 * area / sphere_area() * static_cast<double>(lines_cast); // (G1)
}

double GlobalLines::sphere_area() const
{
    return 4.0 * 3.14159265358979323846 * radius_ * radius_;
}

} // namespace multipath
