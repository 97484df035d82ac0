#pragma once

#include "export/mesh/patch_mesh.h"

#include <string>
#include <vector>

namespace multipath {

/// A mesh as Wavefront OBJ with a colour behind the coordinates of every vertex ("v x y z r g b", sRGB from 0 to 1, as
/// MeshLab and Blender read it). Names of groups and materials are those of the scene; there is no MTL file, since the
/// colours are all there is to show. The comments become `# ` lines at the top.
std::string obj_text(const PatchMesh& mesh, const Scene& scene, const ScreenColour& colour,
                     const std::vector<std::string>& comments);

} // namespace multipath
