#pragma once

#include "export/mesh/patch_mesh.h"

#include <string>
#include <vector>

namespace multipath {

/// A mesh as binary PLY (Stanford's format 1.0, little endian). A vertex has its place, normal, 8-bit colour and
/// radiosity [W/m^2], and the standard error if it is known; a face its patch and the patch's radiosity. The comments
/// become lines of the header.
std::string ply_bytes(const PatchMesh& mesh, const std::vector<Rgb>& radiosity_per_patch, const ScreenColour& colour,
                      const std::vector<std::string>& comments);

} // namespace multipath
