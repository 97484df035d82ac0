#pragma once

#include "export/mesh/patch_mesh.h"

namespace multipath {

/// The mesh without cracks: where corners of sides lie within `tolerance` [scene units] they come to lie in one place,
/// and a face on whose edge another side has a corner is cut into triangles that meet there. Colours stay as they were:
/// new corners get the values of where they are. Clears the lists of rims.
PatchMesh sewn(PatchMesh mesh, double tolerance);

} // namespace multipath
