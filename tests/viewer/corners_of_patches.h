#pragma once

#include "viewer/viewer_page.h"

#include <map>
#include <tuple>
#include <vector>

namespace multipath {

/// The values at the corners of all patches, four each, put together as the page does it.
inline std::vector<Rgb> corners_of_patches(const Scene& scene, const CornerValues& corners)
{
    std::vector<Rgb> result(4 * std::size_t{scene.patch_count()});
    std::map<std::tuple<bool, std::uint32_t, std::uint32_t, std::uint32_t>, std::size_t> numbers;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        for (std::size_t k = 0; k < scene.corners(patch).count; ++k) {
            const GridPoint p = scene.corners(patch).points[k];
            const auto at =
                numbers.insert({{scene.is_front(patch), scene.surface_of(patch), p.i, p.j}, numbers.size()});
            result[4 * patch + k] = corners.values.at(at.first->second);
        }
    for (std::size_t n = 0; n < corners.own_places.size(); ++n)
        result[corners.own_places[n]] = corners.values.at(numbers.size() + n);
    return result;
}

} // namespace multipath
