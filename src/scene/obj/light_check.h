#pragma once

#include "scene/obj/mtl_reader.h"
#include "scene/obj/obj_mesh.h"

#include <string>
#include <vector>

namespace multipath {

/// The materials of a scene as its faces use them.
struct UsedMaterials
{
    std::vector<MtlMaterial> used;          ///< defined, and used by a face
    std::vector<MtlMaterial> unused;        ///< defined only
    std::vector<std::string> unknown_names; ///< used, but defined nowhere: the default material stands in
    bool default_used = false;              ///< for these, or for faces without a material
    std::vector<std::string> files;         ///< MTL files that were read
};

/// Whether there is light, and something that absorbs it. Returns warnings; throws InputError for a scene without an
/// emitter, and for a closed scene where every material reflects all light of one colour.
std::vector<std::string> check_light(const UsedMaterials& materials, const ObjMesh& mesh, EmissionFrom emission_from);

} // namespace multipath
