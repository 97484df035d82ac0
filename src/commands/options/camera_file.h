#pragma once

#include "image/camera.h"

#include <string>

namespace multipath {

/// Reads a view from a JSON file as the page saves it: an object of `eye` and `target` [m], three numbers each, and
/// perhaps `up` (three numbers, else 0, 1, 0) and `fov` (degrees, vertical, 1 to 179, else 60). Throws InputError
/// "FILE:line: what is wrong, what was expected".
Camera read_camera_file(const std::string& path);

} // namespace multipath
