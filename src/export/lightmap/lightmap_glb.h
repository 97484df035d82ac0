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

} // namespace multipath
