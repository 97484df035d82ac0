#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "scene/texture/texture.h"

#include <string>
#include <vector>

namespace multipath {

/// Bytes of a PNG file with 8 bits per channel, sRGB. A comment that is not empty becomes a text chunk, with '?'
/// for control characters except line feeds, as valid_utf8().
std::string png_bytes(const ScreenImage& image, const std::string& comment = "");

/// The scene's textures, in the order of SceneFile::textures, as files for browsers and glTF: PNG and JPEG files
/// unchanged, other formats and JPEG files of inks converted to PNG.
std::vector<ImageFile> texture_files(const Scene& scene);

} // namespace multipath
