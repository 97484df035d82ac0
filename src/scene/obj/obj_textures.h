#pragma once

#include "scene/obj/mesh_pieces.h"
#include "scene/obj/mtl_reader.h"
#include "scene/scene_file.h"

#include <vector>

namespace multipath {

/// Reads the textures of a scene's materials and lays them on its surfaces: the reflectance of a textured material
/// becomes the mean over its surfaces, its emittance that of `map_Ke` times `Ke`. `definitions`: of the materials of
/// the scene; `pieces`: its surfaces. Files that are missing or cannot be read are told, and the material stays as it
/// is. `limit` [1]: of reflectances.
void add_textures(const std::vector<MtlMaterial>& definitions, const LargeVector<Piece>& pieces, const ObjMesh& mesh,
                  double limit, SceneFile& scene);

} // namespace multipath
