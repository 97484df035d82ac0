#pragma once

#include "base/errors.h"
#include "scene/obj/obj_mesh.h"
#include "scene/scene_file.h"

#include <string>
#include <vector>

namespace multipath {

/// A proposal how to light a scene that has no light.
struct LightAdvice
{
    std::string text;           ///< "to make a lamp of material or object `shade` (0.5 m^2, so 5 W)"
    std::vector<Advice> advice; ///< a lamp, or a sky and a sun in the south-south-east
};

/// Proposes a lamp made of the material or object whose name suggests a lamp or a window most, the largest of several,
/// or of the largest material of a room without such a name; in other scenes, a sky and a sun. `scene` holds the faces
/// of the mesh as surfaces; its indices of materials and groups are those of the mesh.
LightAdvice advised_light(const ObjMesh& mesh, const SceneFile& scene);

} // namespace multipath
