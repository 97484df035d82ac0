#include "export/mesh/linear_scale.h"

#include <algorithm>
#include <cstdint>

namespace multipath {

namespace {

struct LitArea
{
    double brightness = 0.0; ///< [W/m^2] of the brightest channel
    double area = 0.0;       ///< [m^2]
};

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

std::vector<LitArea> lit_areas(const Scene& scene, const std::vector<Rgb>& radiosity, bool with_lamps)
{
    std::vector<LitArea> areas;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        if (!scene.is_sky(scene.surface_of(patch)) && (with_lamps || scene.emittance(patch) == Rgb{}))
            areas.push_back({white_brightness(scene, radiosity, patch), scene.area(patch)});
    return areas;
}

/// [W/m^2] The brightness that is reached or exceeded on a share of the area (a weighted quantile). `areas` must be
/// sorted by decreasing brightness.
double exceeded_on(double share, const std::vector<LitArea>& areas)
{
    double total = 0.0;
    for (const LitArea& lit : areas)
        total += lit.area;
    double before = 0.0;
    for (const LitArea& lit : areas) {
        before += lit.area;
        if (before > share * total)
            return lit.brightness;
    }
    return 0.0;
}

} // namespace

double linear_scale(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    std::vector<LitArea> areas = lit_areas(scene, radiosity, false);
    if (areas.empty())
        areas = lit_areas(scene, radiosity, true);
    std::sort(areas.begin(), areas.end(),
              [](const LitArea& a, const LitArea& b) { return a.brightness > b.brightness; });
    const double bright = exceeded_on(0.01, areas);
    const double middle = exceeded_on(0.5, areas);
    if (!(bright > 0.0))
        return 1.0;
    return middle > 0.0 ? std::max(1.0 / bright, 0.18 / middle) : 1.0 / bright;
}

} // namespace multipath
