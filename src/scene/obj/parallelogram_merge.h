#pragma once

#include "scene/obj/mesh_pieces.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// Joins pairs of triangles that form a parallelogram: they share a whole edge (by position), face the same way and
/// have the same material and group. Most exporters cut rectangles in two; whole rectangles give fewer and better
/// patches. The parallelogram replaces its first triangle. Returns the number of pairs. A greedy method in linear time.
std::size_t merge_triangles(LargeVector<Piece>& pieces, const ObjMesh& mesh, const SceneScale& scale);

} // namespace multipath
