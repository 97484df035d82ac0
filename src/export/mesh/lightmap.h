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

/// [W/m^2] Radiosity at a point of a side of a surface, texture included. Called by several threads at once.
using SurfaceLight = std::function<Rgb(std::uint32_t surface, bool front, double u, double v)>;

/// The light on all surfaces of a scene in one picture, the texture atlas. Connected coplanar surfaces of one material
/// are one chart, a rigid copy of them at the common scale; only what is narrower than a texel is stretched to one.
/// Sides whose charts differ are at least four texels apart. The sky has no place in it.
struct Lightmap
{
    std::uint32_t width = 0; ///< [texel]
    std::uint32_t height = 0;
    std::vector<Rgb> texels; ///< [W/m^2] row by row from the top left; those far from all charts hold the mean
    /// How sides lie on the picture, whose lower left corner is (0, 0) and whose upper right corner is (1, 1): the
    /// fronts of Scene::own_surfaces(), then their backs if the scene has two sides.
    std::vector<TextureFrame> frames;
    std::uint32_t chart_count = 0;
    double texels_per_unit = 0.0; ///< [1 / scene unit] the common scale
    double used_share = 0.0;      ///< [1] of the picture that lies on a surface

    const TextureFrame& frame(std::uint32_t surface, bool front) const
    {
        return frames[surface + (front ? 0 : frames.size() / 2)];
    }
};

constexpr std::uint32_t usual_lightmap_size = 2048;
constexpr std::uint32_t largest_lightmap_size = 8192; ///< that graphics processors of all kinds can hold

/// An atlas of size x size texels with the light at the middles of the texels, over textures its mean over the texel.
/// The size is doubled, up to the largest, if the charts do not fit; throws InputError if that does not suffice. The
/// same for any number of threads.
Lightmap lightmap(const Scene& scene, std::uint32_t size, const SurfaceLight& light, int threads,
                  std::uint32_t largest_size = largest_lightmap_size);

/// The surfaces, each one or two triangles, as binary glTF 2.0: one mesh per material, unlit, with the atlas as its
/// texture by TEXCOORD_0, and the cameras. `atlas_png` shows min(1, scale * texels) in sRGB; the asset's extras hold
/// the scale [m^2/W] and the comments. `images`: the scene's own textures, or none. They are kept for who wants to
/// change materials: TEXCOORD_1 says how a textured surface lies on its own, and the material's extras which it is.
/// Throws InputError for 4 GB or more.
std::string lightmap_glb(const Scene& scene, const Lightmap& map, const std::string& atlas_png, double scale,
                         const std::vector<GlbCamera>& cameras, const std::vector<ImageFile>& images,
                         const std::vector<std::string>& comments);

/// The same surfaces as Wavefront OBJ with a texture coordinate for each corner, material by material. The comments
/// become `# ` lines at the top.
std::string lightmap_obj(const Scene& scene, const Lightmap& map, const std::string& mtl_name,
                         const std::vector<std::string>& comments);

/// The materials of lightmap_obj(): all show the atlas.
std::string lightmap_mtl(const Scene& scene, const std::string& png_name);

} // namespace multipath
