#pragma once

#include "scene/obj/obj_mesh.h"
#include "scene/scene_file.h"

#include <string>
#include <vector>

namespace multipath {

/// What gives light to a scene that has none.
struct LightAdvice
{
    std::string lamp;                ///< material or object to become one; empty: better a sky
    double lamp_area = 0.0;          ///< [m^2] of its surfaces
    std::vector<std::string> others; ///< other likely lamps
    double lit_share = 0.0;          ///< [1] of the light of that lamp or sky that arrives on a front, about
};

/// Prefers what is called as lamps or windows are, unless its light would reach nothing; then a sky, if fronts see out;
/// then the material of the largest area that lights others. `scene`: the same faces as surfaces, with the numbers of
/// the mesh's materials and groups.
LightAdvice advised_light(const ObjMesh& mesh, const SceneFile& scene);

} // namespace multipath
