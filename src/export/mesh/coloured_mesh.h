#pragma once

#include "export/mesh/patch_mesh.h"

#include <string>
#include <vector>

namespace multipath {

/// A mesh as a binary PLY file (Stanford's format 1.0, little endian). Each vertex has a position, a normal, a colour
/// (from `colour`, 8 bits per channel) and a radiosity [W/m^2]. The standard error of the radiosity [W/m^2] follows
/// unless PatchMesh::error is empty. Each face has the index of its patch and the radiosity of the patch. The comments
/// become comment lines of the header, and so does PatchMesh::origin unless it is 0 ("offset: x y z").
std::string ply_bytes(const PatchMesh& mesh, const std::vector<Rgb>& radiosity_per_patch, const ScreenColour& colour,
                      const std::vector<std::string>& comments);

/// A mesh as a Wavefront OBJ file with vertex colours ("v x y z r g b", sRGB from 0 to 1, as MeshLab and Blender read
/// them). `colour` maps radiosity to these colours. Groups and materials keep the names that they have in the scene.
/// Coordinates are exact to a millionth of the scene's size. There is no MTL file, since the colours replace the
/// materials. The comments become `# ` lines at the top.
std::string obj_text(const PatchMesh& mesh, const Scene& scene, const ScreenColour& colour,
                     const std::vector<std::string>& comments);

} // namespace multipath
