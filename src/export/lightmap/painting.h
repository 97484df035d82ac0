#pragma once

#include "export/lightmap/lightmap.h"

namespace multipath {

/// Computes the texels of a lightmap whose frames are known. Each texel near a surface gets the light at the point of
/// the surface nearest to the centre of the texel.
void paint(Lightmap& map, const Scene& scene, const SurfaceLight& light, int threads);

} // namespace multipath
