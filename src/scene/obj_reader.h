#pragma once

#include "scene/scene_file.h"

#include <string>

namespace multipath {

enum class EmissionFrom { ke, ka };

/// Reads an OBJ file and the MTL files that it names. Lenient in syntax, strict in meaning: nothing that changes
/// the light of the scene is dropped, guessed or clipped without a word. Parallelogram quads become one surface, other
/// polygons triangles. Throws InputError ("file:line: what is wrong, what was expected").
SceneFile read_obj(const std::string& path, EmissionFrom emission_from = EmissionFrom::ke);

} // namespace multipath
