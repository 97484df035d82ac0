#pragma once

#include "export/mesh/patch_mesh.h"

#include <string>
#include <vector>

namespace multipath {

/// A mesh as a binary PLY file (Stanford's format 1.0, little endian). A vertex has a position, normal, 8-bit colour,
/// radiosity [W/m^2] and, if known, its standard error. A face has the index of its patch and the patch's radiosity.
/// The comments become comment lines of the header.
std::string ply_bytes(const PatchMesh& mesh, const std::vector<Rgb>& radiosity_per_patch, const ScreenColour& colour,
                      const std::vector<std::string>& comments);

} // namespace multipath
