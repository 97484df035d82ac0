#pragma once

#include "scene/obj/obj_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Tolerances in proportion to the size of a scene, so that its unit does not matter.
struct SceneScale
{
    double extent = 0.0; ///< longest side of the box around all faces [scene units]

    /// Triangles up to this area [square scene units] count as degenerate: the square of 1e-7 extents, the resolution
    /// of single precision.
    double smallest_area() const { return 1e-14 * extent * extent; }
    /// Surfaces may miss the corners of the file by this distance [scene units]. A wider gap would show as a crack.
    double widest_crack() const { return 2e-6 * extent; }
};

SceneScale scale_of(const ObjMesh& mesh);

/// A triangle or parallelogram of the mesh. Its corners are vertex indices, counter-clockwise seen from the front.
struct Piece
{
    static constexpr std::uint32_t no_vertex = 0xffffffffu;

    std::array<std::uint32_t, 4> corners; ///< the fourth is no_vertex in a triangle
    std::uint32_t face = 0;               ///< index of the face that the piece is part of
    /// Indices of the texture points of the corners (see ObjMesh::corner_points), or ObjMesh::no_point.
    std::array<std::uint32_t, 4> points = {};

    bool is_triangle() const { return corners[3] == no_vertex; }
};

/// True if the parallelogram v0 + u (v1 - v0) + v (v3 - v0) may replace the quad v0, v1, v2, v3: the distance of its
/// corner v1 + v3 - v0 from v2 is at most widest_crack() and at most 1/1000 of the shorter side at v0.
bool is_parallelogram(Vec3 v0, Vec3 v1, Vec3 v2, Vec3 v3, const SceneScale& scale);

/// True if four texture points form a parallelogram, up to an error of 1/1000 of its shorter side, so that one
/// TextureFrame fits them, or if none of the four corners has a texture point.
bool is_parallelogram(const std::array<std::uint32_t, 4>& points, const ObjMesh& mesh);

/// The faces of a mesh, cut into triangles and parallelograms.
struct MeshPieces
{
    LargeVector<Piece> pieces;       ///< in the order of the faces
    std::size_t zero_area_faces = 0; ///< number of faces without area, which were dropped
    std::vector<std::string> warnings;
};

/// Cuts the faces of a mesh. Corners on a straight side are skipped. A parallelogram stays whole; a textured one is cut
/// unless its texture points form a parallelogram, too. Any other convex quad is cut along the diagonal from its first
/// to its third corner, any other polygon by ear clipping. Polygons that are not planar (off their mean plane by more
/// than 1e-4 of their size and more than widest_crack()) or intersect themselves are cut with a warning. Throws
/// InputError for a concave polygon that would take too long: the number of its corners times the number of its reflex
/// corners exceeds 10^8.
MeshPieces cut_into_pieces(const ObjMesh& mesh, const SceneScale& scale);

} // namespace multipath
