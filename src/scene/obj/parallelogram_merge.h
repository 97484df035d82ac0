#pragma once

#include "scene/obj/mesh_pieces.h"

namespace multipath {

/// Joins pairs of triangles that form a parallelogram: they share a whole edge (by position), face the same way, have
/// the same material, group and colour and, if textured, form one parallelogram in the texture, too. Most exporters cut
/// rectangles in two; whole rectangles give fewer and better patches. The parallelogram takes the place of the first
/// triangle of the pair; otherwise the order of the pieces stays. Corners at the same position get the same vertex in
/// all pieces. A greedy method in linear time.
void merge_triangles(LargeVector<Piece>& pieces, const ObjMesh& mesh, const SceneScale& scale);

} // namespace multipath
