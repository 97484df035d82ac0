#pragma once

#include "export/json.h"
#include "export/mesh/patch_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace multipath {

/// [m^2/W] Scale from radiosity [W/m^2] to linear colours, which are clipped at 1. On 99 % of the area without sources
/// (of all area, if everything emits) no channel exceeds 1, even where a texture is white. If the contrast is too high
/// for that, the scale is larger, so that half of this area reaches 0.18, middle grey. 1 for a dark scene. Independent
/// of any camera, unlike the scale of a picture.
double linear_scale(const Scene& scene, const std::vector<Rgb>& radiosity);

/// A pinhole camera.
struct GlbCamera
{
    std::string name;
    Vec3 eye; ///< [m]
    Vec3 target;
    Vec3 up;              ///< not parallel to the viewing direction
    double field_of_view; ///< [degrees] vertical
};

/// Perspective of a camera as an entry of "cameras" in a glTF file.
JsonObject glb_camera(const GlbCamera& camera, const Scene& scene);

/// Position and orientation of a camera as an entry of "nodes". `number`: index of its entry in "cameras".
JsonObject glb_camera_node(const GlbCamera& camera, std::size_t number);

/// Bytes of a binary glTF 2.0 file: one unlit mesh per material, and the cameras. Attributes of a vertex:
/// - COLOR_0 = min(1, scale * radiosity), linear; floats, so that dark corners keep their shades when brightened;
/// - _RADIOSITY [W/m^2], not clipped, and _ERROR [W/m^2], its standard error, if known.
/// In a scene with textures, `mesh` must contain the radiosity without their detail and `images` one file per texture.
/// Textured materials show the texture times COLOR_0, which then is the colour for a white texture. The extras of the
/// asset contain the scale [m^2/W] and the comments. Throws InputError for 4 GB or more, the limit of the format.
std::string glb_bytes(const PatchMesh& mesh, const Scene& scene, double scale, const std::vector<GlbCamera>& cameras,
                      const std::vector<std::string>& comments, const std::vector<ImageFile>& images = {});

} // namespace multipath
