#pragma once

#include "scene/scene_file.h"

namespace multipath {

/// What numbers of light are measured in. Nothing else differs: of lamps in lm/m^2 all results are photometric.
struct LightUnits
{
    const char* power;
    const char* per_area;
    const char* per_area_utf8;
    const char* per_area_latin1;
    const char* squared; ///< of the one per area
};

inline LightUnits light_units(const SceneFile& scene)
{
    return scene.photometric ? LightUnits{"lm", "lx", "lx", "lx", "lx^2"}
                             : LightUnits{"W", "W/m^2", "W/m\u00b2", "W/m\xB2", "W^2/m^4"};
}

} // namespace multipath
