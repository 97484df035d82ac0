#pragma once

#include "scene/obj/obj_changes.h"
#include "scene/scene_file.h"

#include <string>

namespace multipath {

/// Reads an OBJ file and the MTL files that it names. Lenient in syntax, strict in meaning: nothing that changes the
/// light of the scene is dropped, guessed or clipped without a warning. A parallelogram becomes one surface, even if
/// the file has it as two triangles; other polygons become triangles. Faces without a defined material are grey, with
/// reflectance 0.5. SceneFile::materials holds only materials that faces use. Throws InputError for errors in the
/// files, DarkScene if nothing emits (light_advice.h), and SettingsError for changes that do not fit the file.
SceneFile read_obj(const std::string& path, EmissionFrom emission_from = EmissionFrom::ke,
                   const ObjChanges& changes = {});

} // namespace multipath
