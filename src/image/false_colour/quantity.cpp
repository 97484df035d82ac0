#include "image/false_colour/quantity.h"

#include "geometry/elementary.h"
#include "geometry/pi.h"
#include "image/false_colour/colour_map.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace multipath {

namespace {

// For smaller reflectances the rounding error of B - E would be taken for irradiance if the emittance is large.
constexpr double least_reflectance = 1e-6;

double irradiance(double radiosity, double emittance, double reflectance)
{
    if (reflectance < least_reflectance)
        return std::numeric_limits<double>::quiet_NaN();
    // A mean over replicates may be slightly below E because of rounding.
    return std::max(0.0, radiosity - emittance) / reflectance;
}

} // namespace

std::vector<Rgb> irradiance(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    std::vector<Rgb> result;
    result.reserve(radiosity.size());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Rgb b = radiosity[i];
        const Rgb e = scene.emittance(i);
        const Rgb rho = scene.reflectance(i);
        result.push_back({irradiance(b.r, e.r, rho.r), irradiance(b.g, e.g, rho.g), irradiance(b.b, e.b, rho.b)});
    }
    return result;
}

std::vector<Rgb> magnitudes(const std::vector<Rgb>& values)
{
    std::vector<Rgb> result;
    result.reserve(values.size());
    for (const Rgb& value : values)
        result.push_back({std::abs(value.r), std::abs(value.g), std::abs(value.b)});
    return result;
}

std::vector<Rgb> normal_colours(const Scene& scene)
{
    std::vector<Rgb> colours;
    colours.reserve(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Vec3 n = scene.patch(i).shape.normal();
        colours.push_back({0.5 + 0.5 * n.x, 0.5 + 0.5 * n.y, 0.5 + 0.5 * n.z});
    }
    return colours;
}

std::vector<Rgb> patch_colours(std::size_t patches)
{
    constexpr double chroma = 0.075; // a screen can show all hues of this chroma at these lightnesses
    std::vector<Rgb> colours;
    colours.reserve(patches);
    for (std::size_t patch = 0; patch < patches; ++patch) {
        const double angle = 2.0 * pi * bits_to_unit(random_bits(0, 2 * patch));
        const double lightness = 0.45 + 0.39 * bits_to_unit(random_bits(0, 2 * patch + 1));
        colours.push_back(linear_light({lightness, chroma * elementary::cos(angle), chroma * elementary::sin(angle)}));
    }
    return colours;
}

} // namespace multipath
