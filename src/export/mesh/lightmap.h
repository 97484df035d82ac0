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

/// [W/m^2] Radiosity at a point on one side of a surface, texture included. Called by several threads at once.
using SurfaceLight = std::function<Rgb(std::uint32_t surface, bool front, double u, double v)>;

/// A texture atlas with the light on all surfaces of a scene, except the sky. Connected coplanar surfaces of one
/// material form a chart, which is mapped rigidly at a common scale; only charts narrower than a texel are stretched to
/// one. Charts are at least four texels apart.
struct Lightmap
{
    std::uint32_t width = 0; ///< [texel]
    std::uint32_t height = 0;
    std::vector<Rgb> texels; ///< [W/m^2] row by row from the top left; texels far from all charts have the mean
    /// Position of each side in the atlas, from (0, 0) at the lower left corner to (1, 1) at the upper right: the
    /// fronts of the Scene::own_surfaces(), then their backs if the scene is two-sided.
    std::vector<TextureFrame> frames;
    std::uint32_t chart_count = 0;
    double texels_per_unit = 0.0; ///< [1 / scene unit] the common scale
    double used_share = 0.0;      ///< [1] share of the atlas that lies on a surface

    const TextureFrame& frame(std::uint32_t surface, bool front) const
    {
        return frames[surface + (front ? 0 : frames.size() / 2)];
    }
};

constexpr std::uint32_t default_lightmap_size = 2048;
constexpr std::uint32_t largest_lightmap_size = 8192; ///< supported by all common graphics processors

/// Computes an atlas of size x size texels, with the light at the centre of each texel or, on textured surfaces, its
/// mean over the texel. If the charts do not fit, the size is doubled, up to `largest_size`; throws InputError if that
/// does not suffice. The result does not depend on the number of threads.
Lightmap lightmap(const Scene& scene, std::uint32_t size, const SurfaceLight& light, int threads,
                  std::uint32_t largest_size = largest_lightmap_size);

/// Bytes of a binary glTF 2.0 file with the cameras and the surfaces, each as one or two triangles: one unlit mesh per
/// material, with the atlas as its texture through TEXCOORD_0. `atlas_png` must show min(1, scale * texels) in sRGB.
/// The extras of the asset contain the scale [m^2/W] and the comments. `images`: the scene's own textures, or none.
/// They are included for users who change materials: TEXCOORD_1 holds their coordinates, and the extras of a material
/// the index of its texture. Throws InputError for 4 GB or more.
std::string lightmap_glb(const Scene& scene, const Lightmap& map, const std::string& atlas_png, double scale,
                         const std::vector<GlbCamera>& cameras, const std::vector<ImageFile>& images,
                         const std::vector<std::string>& comments);

/// The surfaces as a Wavefront OBJ file with texture coordinates into the atlas, grouped by material. The comments
/// become `# ` lines at the top.
std::string lightmap_obj(const Scene& scene, const Lightmap& map, const std::string& mtl_name,
                         const std::vector<std::string>& comments);

/// The MTL file of lightmap_obj(): every material shows the atlas.
std::string lightmap_mtl(const Scene& scene, const std::string& png_name);

} // namespace multipath
