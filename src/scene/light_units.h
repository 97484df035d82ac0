#pragma once

#include "scene/scene_file.h"

namespace multipath {

/// Names of the units of results: photometric if emittances are given in lm/m^2, else radiometric. The numbers are
/// computed in the same way.
struct LightUnits
{
    const char* power;
    const char* per_area;
    const char* per_area_utf8;
    const char* per_area_latin1;
    const char* squared; ///< unit of per_area squared, for mean square errors
};

inline LightUnits light_units(const SceneFile& scene)
{
    return scene.photometric ? LightUnits{"lm", "lx", "lx", "lx", "lx^2"}
                             : LightUnits{"W", "W/m^2", "W/m\u00b2", "W/m\xB2", "W^2/m^4"};
}

} // namespace multipath
