#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "scene/texture/texture.h"

#include <string>
#include <vector>

namespace multipath {

/// Bytes of a PNG file with 8 bits per channel, sRGB. The comment becomes a text chunk, in which control characters
/// other than line feeds and bytes that are not UTF-8 become '?'; there is no chunk if it is empty.
std::string png_bytes(const ScreenImage& image, const std::string& comment = "");

/// The scene's textures as files for browsers and glTF: PNG and JPEG files unchanged, other formats as PNG.
std::vector<ImageFile> texture_files(const Scene& scene);

} // namespace multipath
