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
        Rgb emittance; ///< [W/m^2] replaces that of the file
    };

    std::vector<Lamp> lamps;
    std::vector<std::string> ignored; ///< names whose faces are left out
    double reflectance_limit = 1.0;   ///< [1] larger channels are lowered to this; if it is 1, larger ones are refused
    double unit = 1.0;                ///< [m] unit of the file's coordinates
    bool lit_from_outside = false;    ///< a sky or sun is added, so no emitter is needed
    std::string options = {};         ///< as on the command line, " --ignore glass", for commands in messages
};

/// A material of a mesh that is made a lamp.
struct LampMaterial
{
    std::uint32_t material; ///< index into ObjMesh::materials
    Rgb emittance;          ///< [W/m^2]
    std::string object;     ///< object whose faces have it; empty if the lamp was named by its material
};

/// Removes the ignored faces from the mesh. Objects that are made lamps get their own copies of their materials, with
/// the same names. Returns the materials of lamps. Throws SettingsError for a name that the mesh does not have or that
/// has no faces, and if no faces are left.
std::vector<LampMaterial> apply(const ObjChanges& changes, ObjMesh& mesh);

} // namespace multipath
