#pragma once

#include "scene/obj/mesh_pieces.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// Joins pairs of triangles that form a parallelogram: they share a whole edge (by position), face the same way and
/// have the same material and group. Most exporters cut every rectangle in two; whole ones make fewer and better
/// patches. The joined piece takes the place of its first triangle. Returns the number of pairs. Greedy, linear time.
std::size_t merge_triangles(LargeVector<Piece>& pieces, const ObjMesh& mesh, const SceneScale& scale);

} // namespace multipath
