#pragma once

#include "image/smooth_shading.h"
#include "test_scenes.h"

#include <cstdint>
#include <vector>

namespace multipath {

inline Rgb grey(double value)
{
    return {value, value, value};
}

/// One value per patch from the point at its centre.
template <class F>
std::vector<Rgb> at_centres(const Scene& scene, const F& value)
{
    std::vector<Rgb> values;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        values.push_back(grey(value(scene.patch(patch).shape.centre())));
    return values;
}

inline double shown(const SmoothShading& shading, std::uint32_t surface, double u, double v, bool front = true)
{
    return shading.at({0.0, surface, u, v, front}).r;
}

/// A small lamp, because a scene must have one; far from everything else.
inline SceneBuilder with_lamp()
{
    SceneBuilder builder;
    return builder.rectangle({0.0, 50.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.grey(0.5, 1.0));
}

} // namespace multipath
