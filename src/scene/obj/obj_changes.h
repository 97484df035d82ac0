#pragma once

#include "scene/obj/obj_mesh.h"
#include "scene/rgb.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Changes to the contents of a file that the user asks for by options. Names are those of materials or, if no material
/// has the name, of objects or groups.
struct ObjChanges
{
    struct Lamp
    {
        std::string name;
        Rgb emittance; ///< [W/m^2] replaces the emittance in the file
    };

    std::vector<Lamp> lamps;
    std::vector<std::string> ignored; ///< names whose faces are left out
    /// [1] If below 1, larger channels of reflectances are lowered to it; if 1, reflectances above 1 are refused.
    double reflectance_limit = 1.0;
    double unit = 1.0;             ///< [m] unit of the file's coordinates
    bool lit_from_outside = false; ///< a sky or sun is added, so no emitter is needed
};

/// A material of a mesh that an ObjChanges::Lamp turned into an emitter.
struct LampMaterial
{
    std::uint32_t material; ///< index into ObjMesh::materials
    Rgb emittance;          ///< [W/m^2]
    std::string object; ///< object or group whose faces have the material; empty if the lamp was named by its material
};

/// Removes the ignored faces from the mesh, and returns the materials of lamps. The faces of an object or group that is
/// named as a lamp get copies of their materials under the same names, so that other faces with these materials do not
/// emit. Throws SettingsError for a name that the mesh does not have or that has no faces, and if no faces are left.
std::vector<LampMaterial> apply(const ObjChanges& changes, ObjMesh& mesh);

} // namespace multipath
