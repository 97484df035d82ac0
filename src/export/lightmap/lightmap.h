#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"
#include "scene/texture/texture.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// [W/m^2] Radiosity at the point (u, v) on one side of a surface, texture included. Called by several threads at once.
using SurfaceLight = std::function<Rgb(std::uint32_t surface, bool front, double u, double v)>;

/// A texture atlas with the light on all surfaces of a scene, except the sky. Each side of a surface is a chart. Charts
/// are mapped without distortion at a common scale, but a width or height below one texel is stretched to one texel.
/// Charts are at least four texels apart.
struct Lightmap
{
    std::uint32_t width = 0; ///< [texel]
    std::uint32_t height = 0;
    std::vector<Rgb> texels; ///< [W/m^2] row by row from the top left; black far from all charts
    /// Position of each side of a surface in the atlas, from (0, 0) at the lower left corner to (1, 1) at the upper
    /// right. First come the fronts of all Scene::own_surfaces(), then their backs if the scene is two-sided.
    std::vector<TextureFrame> frames;
    double texels_per_unit = 0.0; ///< [1 / scene unit] the common scale

    const TextureFrame& frame(std::uint32_t surface, bool front) const
    {
        return frames[surface + (front ? 0 : frames.size() / 2)];
    }
};

constexpr std::uint32_t default_lightmap_size = 2048;
constexpr std::uint32_t largest_lightmap_size = 8192; ///< supported by all common graphics processors

/// Computes an atlas of size x size texels, with the light at the centre of each texel or, on textured surfaces, the
/// mean light over the texel. Texels around a chart get the light of the nearest point of the chart. If the charts do
/// not fit, the size is doubled repeatedly, up to `largest_size`. Throws InputError if the charts still do not fit,
/// std::invalid_argument for size 0. The result does not depend on the number of threads.
Lightmap lightmap(const Scene& scene, std::uint32_t size, const SurfaceLight& light, int threads,
                  std::uint32_t largest_size = largest_lightmap_size);

} // namespace multipath
