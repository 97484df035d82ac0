#pragma once

#include "image/camera.h"

#include <string>

namespace multipath {

/// Reads a view from a JSON file, like those that the HTML page of a solution saves: an object with `eye` and `target`
/// [m], three numbers each, and optionally `up` (three numbers, default 0, 1, 0) and `fov` (vertical field of view, 1
/// to 179 degrees, default 60). Throws InputError "FILE:line: problem, expected ..." for any other content. The message
/// has no line if the file cannot be read (bytes_of_file()), if `eye` or `target` is missing, and if the camera looks
/// at its own position or along `up`.
Camera read_camera_file(const std::string& path);

} // namespace multipath
