#pragma once

#include "scene/obj/obj_mesh.h"
#include "scene/rgb.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// What the user makes of a file besides what it says. Names are those of materials; where no material has one, of
/// objects or groups.
struct ObjChanges
{
    struct Lamp
    {
        std::string name;
        Rgb emittance; ///< [W/m^2] instead of its own
    };

    std::vector<Lamp> lamps;
    std::vector<std::string> ignored; ///< whose faces are left out
    double reflectance_limit = 1.0;   ///< [1] to which each colour of a reflectance above it is lowered; 1: refused
    double unit = 1.0;                ///< [m] of the file's coordinates
    bool lit_from_outside = false;    ///< by a sky or the sun, so that no emitter is needed
    std::string options = {};         ///< " --ignore glass": of the command line, for commands in messages
};

/// A material of a mesh that becomes a lamp.
struct LampMaterial
{
    std::uint32_t material; ///< index into ObjMesh::materials
    Rgb emittance;          ///< [W/m^2]
    std::string object;     ///< whose faces alone have it; empty for a lamp that is named by its material
};

/// Leaves out the faces of what is ignored, and gives those of objects that become lamps materials of their own, of the
/// same name as before. Throws SettingsError for a name that the mesh does not have, and for a mesh without faces left.
std::vector<LampMaterial> apply(const ObjChanges& changes, ObjMesh& mesh);

} // namespace multipath
