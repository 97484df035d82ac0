#include "export/mesh/linear_scale.h"

#include <algorithm>

namespace multipath {

namespace {

struct LitArea
{
    double brightness = 0.0; ///< [W/m^2] of the brightest channel
    double area = 0.0;       ///< [m^2]
};

std::vector<LitArea> lit_areas(const Scene& scene, const std::vector<Rgb>& radiosity, bool with_lamps)
{
    std::vector<LitArea> areas;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        if (with_lamps || scene.emittance(patch) == Rgb{})
            areas.push_back(
                {std::max({radiosity[patch].r, radiosity[patch].g, radiosity[patch].b}), scene.area(patch)});
    return areas;
}

/// The brightness that is exceeded on a share of the area. `areas` is sorted, the brightest first.
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
