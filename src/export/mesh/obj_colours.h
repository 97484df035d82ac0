#pragma once

#include "export/mesh/patch_mesh.h"

#include <string>
#include <vector>

namespace multipath {

/// A mesh as a Wavefront OBJ file with vertex colours ("v x y z r g b", sRGB from 0 to 1, as MeshLab and Blender read
/// them). Groups and materials have the names of the scene's. There is no MTL file, since the colours replace the
/// materials. The comments become `# ` lines at the top.
std::string obj_text(const PatchMesh& mesh, const Scene& scene, const ScreenColour& colour,
                     const std::vector<std::string>& comments);

} // namespace multipath
