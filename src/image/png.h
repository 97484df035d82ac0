#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "scene/texture/texture.h"

#include <string>
#include <vector>

namespace multipath {

/// A PNG file, 8 bits per channel, sRGB. The comment may be empty; png_comment reads it again. What is neither
/// printable, a line feed nor well-formed UTF-8 becomes '?'.
std::string png_bytes(const ScreenImage& image, const std::string& comment = "");

/// The scene's textures for browsers and glTF: PNG and JPEG files as they are, others as PNG.
std::vector<ImageFile> texture_files(const Scene& scene);

} // namespace multipath
