#pragma once

#include "scene/obj/obj_changes.h"
#include "scene/scene_file.h"

#include <string>

namespace multipath {

/// Reads an OBJ file and the MTL files that it names. Lenient in syntax, strict in meaning: nothing that changes the
/// light of the scene is dropped, guessed or clipped without a warning.
///
/// A parallelogram becomes one surface, even if the file has it as two triangles of the same material and group; other
/// polygons become triangles, and so do textured parallelograms whose texture coordinates do not form a parallelogram.
/// Faces without a defined material are grey, with reflectance 0.5. SceneFile::materials holds only materials that
/// faces of the file use.
///
/// Throws SettingsError if a name in `changes` is not in the file or no face is left (see apply()), InputError for
/// errors in the files and for scenes without a finite solution, or in which nothing emits unless
/// changes.lit_from_outside is set.
SceneFile read_obj(const std::string& path, const ObjChanges& changes = {});

} // namespace multipath
