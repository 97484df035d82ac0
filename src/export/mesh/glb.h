#pragma once

#include "export/mesh/gltf_nodes.h"
#include "export/mesh/patch_mesh.h"

#include <string>
#include <vector>

namespace multipath {

/// Bytes of a binary glTF 2.0 file with the cameras and one unlit mesh per material. A textured material gets a second
/// mesh for its surfaces without texture coordinates. Attributes of a vertex:
/// - COLOR_0 = min(1, scale * radiosity), linear; floats, so that dark corners keep their shades when brightened;
/// - _RADIOSITY [W/m^2], not clipped, and _ERROR [W/m^2], the standard error of the radiosity, if known.
/// In a scene with textures, `mesh` must contain the radiosity without the detail of textures (without_texture()), and
/// `images` one file per texture (texture_files()). Textured materials show the texture times COLOR_0, which is
/// therefore the colour of a white point of the texture: the radiosity is first multiplied by white / mean reflectance.
/// The extras of the asset contain the scale [m^2/W] and the comments. `up`: upward direction of the scene. Throws
/// InputError for 4 GB or more, the limit of the format.
std::string glb_bytes(const PatchMesh& mesh, const Scene& scene, double scale, const std::vector<GlbCamera>& cameras,
                      const std::vector<std::string>& comments, const std::vector<ImageFile>& images = {},
                      Vec3 up = {0.0, 1.0, 0.0});

} // namespace multipath
