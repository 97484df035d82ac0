#pragma once

#include "export/mesh/glb.h"
#include "scene/rgb.h"
#include "scene/scene.h"
#include "scene/texture/texture.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace multipath {

/// [W/m^2] Radiosity at the point (u, v) on one side of a surface, texture included. Called by several threads at once.
using SurfaceLight = std::function<Rgb(std::uint32_t surface, bool front, double u, double v)>;

/// A texture atlas with the light on all surfaces of a scene, except the sky. Connected coplanar surfaces of one
/// material form a chart. Charts are mapped without distortion at a common scale, but a width or height below one texel
/// is stretched to one texel. Charts are at least four texels apart.
struct Lightmap
{
    std::uint32_t width = 0; ///< [texel]
    std::uint32_t height = 0;
    /// [W/m^2] row by row from the top left; texels far from all charts have the mean of the others.
    std::vector<Rgb> texels;
    /// Position of each side of a surface in the atlas, from (0, 0) at the lower left corner to (1, 1) at the upper
    /// right. First come the fronts of all Scene::own_surfaces(), then their backs if the scene is two-sided.
    std::vector<TextureFrame> frames;
    std::uint32_t chart_count = 0; ///< in a two-sided scene front and back count separately
    double texels_per_unit = 0.0;  ///< [1 / scene unit] the common scale
    double used_share = 0.0;       ///< [1] share of the area of the atlas that lies on a surface

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

/// Bytes of a binary glTF 2.0 file with the cameras, and with one or two triangles for each side of a surface in the
/// atlas. There is one mesh per used material, with an unlit glTF material that shows the atlas through TEXCOORD_0.
/// `atlas_png` must show min(1, scale * texels) in sRGB. The extras of the asset contain the scale [m^2/W] and the
/// comments. `images`: the scene's own textures, or none. They are for users who change materials: TEXCOORD_1 holds
/// their texture coordinates, and the extras of each textured material hold the index of its texture. `up`: upward
/// direction of the scene. Throws InputError for 4 GB or more.
std::string lightmap_glb(const Scene& scene, const Lightmap& map, const std::string& atlas_png, double scale,
                         const std::vector<GlbCamera>& cameras, const std::vector<ImageFile>& images,
                         const std::vector<std::string>& comments, Vec3 up = {0.0, 1.0, 0.0});

/// The surfaces as a Wavefront OBJ file with texture coordinates into the atlas, grouped by material, and exact to a
/// millionth of the scene's size. `mtl_name`: name of the MTL file. The comments become `# ` lines at the top.
std::string lightmap_obj(const Scene& scene, const Lightmap& map, const std::string& mtl_name,
                         const std::vector<std::string>& comments);

/// The MTL file of lightmap_obj(): every used material shows the atlas, the file `png_name`.
std::string lightmap_mtl(const Scene& scene, const std::string& png_name);

} // namespace multipath
