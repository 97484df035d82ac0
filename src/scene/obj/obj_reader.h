#pragma once

#include "scene/obj/obj_changes.h"
#include "scene/scene_file.h"

#include <string>

namespace multipath {

/// Reads an OBJ file and the MTL files that it names. Lenient in syntax, strict in meaning: nothing that changes the
/// light of the scene is dropped, guessed or clipped without a word. Parallelograms become one surface, also those that
/// were cut into two triangles; other polygons become triangles. What has no defined material is grey, reflectance 0.5.
/// SceneFile::materials holds the used ones only. Throws InputError ("file:line: what is wrong, what was expected"),
/// DarkScene if nothing emits (light_advice.h), and SettingsError for changes of what the file does not have.
SceneFile read_obj(const std::string& path, EmissionFrom emission_from = EmissionFrom::ke,
                   const ObjChanges& changes = {});

} // namespace multipath
