#pragma once

#include "export/lightmap/lightmap.h"
#include "export/mesh/gltf_nodes.h"

#include <string>
#include <vector>

namespace multipath {

/// Bytes of a binary glTF 2.0 file with the cameras, and with one or two triangles for each side of a surface in the
/// atlas. There is one mesh per used material, with an unlit glTF material that shows the atlas through TEXCOORD_0.
/// `atlas_png` must show min(1, scale * texels) in sRGB. The extras of the asset contain the scale [m^2/W] and the
/// comments. TEXCOORD_1 holds the coordinates of the scene's own textures, for users who change materials. `up`: upward
/// direction of the scene. Throws InputError for 4 GB or more.
std::string lightmap_glb(const Scene& scene, const Lightmap& map, const std::string& atlas_png, double scale,
                         const std::vector<GlbCamera>& cameras, const std::vector<std::string>& comments,
                         Vec3 up = {0.0, 1.0, 0.0});

/// The surfaces as a Wavefront OBJ file with texture coordinates into the atlas, grouped by material, and exact to a
/// millionth of the scene's size. `mtl_name`: name of the MTL file. The comments become `# ` lines at the top.
std::string lightmap_obj(const Scene& scene, const Lightmap& map, const std::string& mtl_name,
                         const std::vector<std::string>& comments);

/// The MTL file of lightmap_obj(): every used material shows the atlas, the file `png_name`.
std::string lightmap_mtl(const Scene& scene, const std::string& png_name);

} // namespace multipath
