#include "radiosity/line_sampling.h"

#include "sampling/warp.h"

#include <cmath>

namespace multipath {

GlobalLines::GlobalLines(const Bounds& scene_box)
    : centre_(scene_box.centre()), radius_(0.5 * scene_box.diagonal()), box_area_(scene_box.area())
{
}

Line GlobalLines::line(const Item& item) const
{
    const Vec3 from = centre_ + radius_ * square_to_uniform_sphere(item[0], item[1]);
    const Vec3 to = centre_ + radius_ * square_to_uniform_sphere(item[2], item[3]);
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
