#pragma once

#include "export/mesh/patch_mesh.h"

#include <string>
#include <vector>

namespace multipath {

/// A mesh as a binary PLY file (Stanford's format 1.0, little endian). Each vertex has a position, a normal, an 8-bit
/// colour (`colour`), and the radiosity and, if PatchMesh::error is not empty, its standard error [W/m^2]. Each face
/// has the index of its patch and the radiosity of the patch. The comments become comment lines of the header.
std::string ply_bytes(const PatchMesh& mesh, const std::vector<Rgb>& radiosity_per_patch, const ScreenColour& colour,
                      const std::vector<std::string>& comments);

} // namespace multipath
