#pragma once

#include "scene/obj/mesh_pieces.h"
#include "scene/obj/mtl_reader.h"
#include "scene/scene_file.h"

#include <vector>

namespace multipath {

/// Reads the textures of a scene's materials and maps them onto its surfaces. The reflectance of a textured material
/// becomes the mean over its surfaces, its emittance the mean of `map_Ke` times `Ke`. A file that is missing or cannot
/// be read leaves its material unchanged, with a warning. `definitions` and `pieces` have one entry per material and
/// surface of the scene; `limit` [1] is the upper limit of Kd as the factor of a texture.
void add_textures(const std::vector<MtlMaterial>& definitions, const LargeVector<Piece>& pieces, const ObjMesh& mesh,
                  double limit, SceneFile& scene);

} // namespace multipath
