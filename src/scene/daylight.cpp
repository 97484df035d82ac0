#include "scene/daylight.h"

#include "base/elementary.h"
#include "geometry/bounds.h"
#include "geometry/intersector/surface_sizes.h"

#include <cmath>

namespace multipath {

void add_sky(SceneFile& file, Rgb emittance)
{
    constexpr double distance = 0.05; // relative to the diagonal: no surface may lie in a plane of the sky
    const Bounds box = bounds_of(file.surfaces);
    const Vec3 margin = distance * box.diagonal() * Vec3{1, 1, 1};
    const auto material = static_cast<std::uint32_t>(file.materials.size());
    const auto group = static_cast<std::uint32_t>(file.groups.size());
    file.materials.push_back({"sky", {}, emittance, file.path});
    file.groups.emplace_back("sky");
    for (const Surface& wall : walls_of_room(box.low - margin, box.size() + 2.0 * margin))
        file.surfaces.push_back(wall);
    file.sky_surfaces = 6;
    file.material.resize(file.surfaces.size(), material);
    file.group.resize(file.surfaces.size(), group);
    file.line.resize(file.surfaces.size(), 0);
}

Sun sun_at(double azimuth, double elevation, Vec3 up, Rgb irradiance)
{
    const Vec3 zenith = normalized(up);
    const Vec3 aside = std::abs(zenith.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{0.0, -1.0, 0.0};
    const Vec3 east = normalized(cross(zenith, aside));
    const Vec3 north = cross(zenith, east);
    const double a = azimuth * (pi / 180.0);
    const double h = elevation * (pi / 180.0);
    const Vec3 toward = elementary::cos(h) * elementary::sin(a) * east +
                        elementary::cos(h) * elementary::cos(a) * north + elementary::sin(h) * zenith;
    // The last bits of sines may differ between machines; rounded values are the same, and so is all that follows.
    const auto rounded = [](double x) { return std::ldexp(std::round(std::ldexp(x, 40)), -40); };
    return {normalized({rounded(toward.x), rounded(toward.y), rounded(toward.z)}), irradiance};
}

} // namespace multipath
