#include "export/lightmap/lightmap.h"

#include "base/errors.h"
#include "export/lightmap/charts.h"
#include "export/lightmap/packing.h"
#include "export/lightmap/painting.h"

#include <cstddef>
#include <optional>
#include <stdexcept>

namespace multipath {

Lightmap lightmap(const Scene& scene, std::uint32_t size, const SurfaceLight& light, int threads,
                  std::uint32_t largest_size)
{
    if (size == 0)
        throw std::invalid_argument("a lightmap without texels");
    const ChartList list = charts_of(scene);
    std::optional<AtlasPacking> packing = packed(list.charts, scene.two_sided(), size);
    while (!packing && size <= largest_size / 2) {
        size *= 2;
        packing = packed(list.charts, scene.two_sided(), size);
    }
    if (!packing)
        throw InputError(scene.path() + ": its surfaces do not fit into a lightmap of " + std::to_string(size) + " x " +
                         std::to_string(size) + " texels; expected fewer surfaces");

    Lightmap map;
    map.width = size;
    map.height = size;
    map.texels.resize(std::size_t{size} * size);
    map.chart_count = static_cast<std::uint32_t>(packing->positions.size());
    map.texels_per_unit = packing->scale;
    map.frames.resize((scene.two_sided() ? 2 : 1) * std::size_t{scene.own_surfaces()});
    for (std::size_t n = 0; n < packing->positions.size(); ++n) {
        const Chart& chart = list.charts[n % list.charts.size()];
        const std::size_t first_side = n < list.charts.size() ? 0 : scene.own_surfaces();
        for (std::size_t k = chart.first; k < chart.first + chart.count; ++k) {
            const std::uint32_t s = list.surfaces[k];
            map.frames[first_side + s] = atlas_frame(scene.surfaces()[s], chart, packing->positions[n], *packing);
        }
    }
    paint(map, scene, list, light, threads);
    return map;
}

} // namespace multipath
