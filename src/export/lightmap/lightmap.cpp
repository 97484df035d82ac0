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
    const std::vector<Chart> charts = charts_of(scene);
    std::optional<AtlasPacking> packing = packed(charts, size);
    for (; !packing && size <= largest_size / 2; packing = packed(charts, size))
        size *= 2;
    if (!packing)
        throw InputError(scene.path() + ": its surfaces do not fit into a lightmap of " + std::to_string(size) + " x " +
                         std::to_string(size) + " texels; expected fewer surfaces");

    Lightmap map;
    map.width = size;
    map.height = size;
    map.texels.resize(std::size_t{size} * size);
    map.texels_per_unit = packing->scale;
    for (std::size_t side = 0; side < charts.size(); ++side)
        map.frames.push_back(atlas_frame(scene.surfaces()[side % scene.own_surfaces()], charts[side],
                                         packing->positions[side], *packing));
    paint(map, scene, light, threads);
    return map;
}

} // namespace multipath
