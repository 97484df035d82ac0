#include "export/mesh/linear_scale.h"

#include "base/lists.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>

namespace multipath {

namespace {

/// Areas of patches [m^2] by the brightness of their brightest channel [W/m^2], the brightest first.
using LitAreas = std::multimap<double, double, std::greater<>>;

/// [W/m^2] Brightest channel of a patch; of a textured patch as if its texture were white.
double white_brightness(const Scene& scene, const std::vector<Rgb>& radiosity, std::uint32_t patch)
{
    Rgb light = radiosity[patch];
    if (scene.shows_texture(scene.surface_of(patch))) {
        constexpr double black = 1e-3; // share of white below which a texture is too dark to infer the light on it
        const auto lit = [](double b, double w, double r) { return r > black * w ? b * w / r : b; };
        light = by_channel(lit, light, scene.material_of(patch).texture_scale, scene.reflectance(patch));
    }
    return std::max({light.r, light.g, light.b});
}

LitAreas lit_areas(const Scene& scene, const std::vector<Rgb>& radiosity, bool with_lamps)
{
    LitAreas areas;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        if (!scene.is_sky(scene.surface_of(patch)) && (with_lamps || scene.emittance(patch) == Rgb{}))
            areas.emplace(white_brightness(scene, radiosity, patch), scene.area(patch));
    return areas;
}

/// [W/m^2] The brightness that is reached or exceeded on a share of the area (a weighted quantile).
double exceeded_on(double share, const LitAreas& areas)
{
    const double total = sum_over(areas, &LitAreas::value_type::second);
    double before = 0.0;
    for (const auto& [brightness, area] : areas) {
        before += area;
        if (before > share * total)
            return brightness;
    }
    return 0.0;
}

} // namespace

double linear_scale(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    LitAreas areas = lit_areas(scene, radiosity, false);
    if (areas.empty())
        areas = lit_areas(scene, radiosity, true);
    const double bright = exceeded_on(0.01, areas);
    const double middle = exceeded_on(0.5, areas);
    if (!(bright > 0.0))
        return 1.0;
    return middle > 0.0 ? std::max(1.0 / bright, 0.18 / middle) : 1.0 / bright;
}

} // namespace multipath
