#pragma once

#include "scene/scene_file.h"

namespace multipath {

/// Names of the units of results: photometric if the emittances of the scene are in lm/m^2, else radiometric. The
/// numbers are computed in the same way for both.
struct LightUnits
{
    const char* power;           ///< [W] or [lm]
    const char* per_area;        ///< [W/m^2] or [lx], in ASCII
    const char* per_area_utf8;   ///< the same in UTF-8
    const char* per_area_latin1; ///< the same in ISO 8859-1
    const char* squared;         ///< square of `per_area`, the unit of mean square errors
};

inline LightUnits light_units(const SceneFile& scene)
{
    return scene.photometric ? LightUnits{"lm", "lx", "lx", "lx", "lx^2"}
                             : LightUnits{"W", "W/m^2", "W/m\u00b2", "W/m\xB2", "W^2/m^4"};
}

} // namespace multipath
