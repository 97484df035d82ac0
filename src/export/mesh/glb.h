#pragma once

#include "export/json.h"
#include "export/mesh/patch_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace multipath {

/// [m^2/W] Scale from radiosity [W/m^2] to linear colours, which are clipped at 1. The scale is the largest at which no
/// channel exceeds 1 on 99 % of the area, with every texture taken as white. If the brightest channel would then reach
/// 0.18, middle grey, on less than half of the area although more than half is lit, the scale is raised until it does;
/// then more than 1 % of the area is clipped. The area is that of all patches except sources and sky (only except the
/// sky, if everything emits). Returns 1 if at most 1 % of the area is lit. Independent of any camera, unlike the scale
/// of a picture.
double linear_scale(const Scene& scene, const std::vector<Rgb>& radiosity);

/// A pinhole camera.
struct GlbCamera
{
    std::string name;
    Vec3 eye;             ///< [m]
    Vec3 target;          ///< [m] point in the middle of the picture
    Vec3 up;              ///< upward direction, not parallel to the viewing direction
    double field_of_view; ///< [degrees] vertical
};

/// The nodes of a glTF file and what they refer to.
struct GlbNodes
{
    std::vector<JsonObject> nodes;   ///< the meshes, then the cameras, then the node that moves all of them, if any
    std::vector<JsonObject> cameras; ///< their near planes depend on the size of the scene
    std::vector<double> roots;       ///< indices of the nodes that have no parent
};

/// The nodes for meshes with these names, whose positions are relative to mesh_origin(), and for cameras. One more node
/// moves all of them back from there and turns `up` to y, as glTF wants it; there is none if it would change nothing.
GlbNodes glb_nodes(const Scene& scene, const std::vector<std::string>& mesh_names,
                   const std::vector<GlbCamera>& cameras, Vec3 up);

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
