#pragma once

#include "export/json.h"
#include "export/mesh/patch_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace multipath {

/// [m^2/W] The scale for linear colours that cannot exceed 1. On 99 % of the area that does not emit (of all area, if
/// everything emits) no channel does, nor where a texture is white; but where light and dark are too far apart for
/// that, half of this area is at least at 0.18, the grey of photographers. From the radiosity [W/m^2] per patch; 1 for
/// a dark scene. Unlike a picture's scale it depends on no camera.
double linear_scale(const Scene& scene, const std::vector<Rgb>& radiosity);

/// A pinhole camera.
struct GlbCamera
{
    std::string name;
    Vec3 eye; ///< [m]
    Vec3 target;
    Vec3 up;              ///< not along the view
    double field_of_view; ///< [degrees] vertical
};

/// The lens of a camera in a glTF file, and its node; `number`: of the lens in the file.
JsonObject glb_camera(const GlbCamera& camera, const Scene& scene);
JsonObject glb_camera_node(const GlbCamera& camera, std::size_t number);

/// A mesh as binary glTF 2.0: one mesh per material, unlit, and the cameras. In a scene with textures the mesh must
/// hold the radiosity without their detail; their materials show the texture (one of `images` for each of the scene's)
/// times COLOR_0, which then is that of a white texture. COLOR_0 is linear, min(1, scale * radiosity); it is a float,
/// so that dark corners keep their shades when a program brightens them. _RADIOSITY [W/m^2] keeps what COLOR_0 clips;
/// _ERROR is its standard error, if known. The asset's extras hold the scale [m^2/W] and the comments. Throws
/// InputError for 4 GB or more, which the format cannot hold.
std::string glb_bytes(const PatchMesh& mesh, const Scene& scene, double scale, const std::vector<GlbCamera>& cameras,
                      const std::vector<std::string>& comments, const std::vector<ImageFile>& images = {});

} // namespace multipath
