#pragma once

#include "geometry/surface.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// A room of 6 walls with a lamp below the ceiling and so many boxes of 6 sides in it, standing or hanging, turned by
/// different angles: 7 + 6 * boxes rectangles, the lamp first.
SurfaceList room_with_boxes(int boxes);

/// Triangles of about this size scattered through the unit cube.
SurfaceList triangle_soup(std::size_t count, double size);

/// The same surfaces, rectangles cut into n x n cells of two triangles; triangles as they are, n = 1.
SurfaceList as_triangles(const SurfaceList& surfaces, int n);

/// A scene of these surfaces, grey, whose first one emits, cut into about so many patches.
Scene scene_of(const SurfaceList& surfaces, std::uint64_t patches);

} // namespace multipath
