#pragma once

#include "scene/obj/obj_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Tolerances relative to the size of a scene, so that its unit does not matter.
struct SceneScale
{
    double extent = 0.0; ///< longest side of the box around all faces [scene units]

    /// Triangles up to this area count as degenerate: the square of 1e-7 extents, the resolution of single precision.
    double smallest_area() const { return 1e-14 * extent * extent; }
    /// Surfaces may miss the corners of the file by this distance; a wider gap would show as a crack.
    double widest_crack() const { return 2e-6 * extent; }
};

SceneScale scale_of(const ObjMesh& mesh);

/// A triangle or parallelogram of the mesh, given by vertex indices, counter-clockwise seen from its front.
struct Piece
{
    static constexpr std::uint32_t no_vertex = 0xffffffffu;

    std::array<std::uint32_t, 4> corners;     ///< the last is no_vertex in a triangle
    std::uint32_t face = 0;                   ///< index of the face that it is part of
    std::array<std::uint32_t, 4> points = {}; ///< texture points of the corners, or no_point

    bool is_triangle() const { return corners[3] == no_vertex; }
};

/// True if the parallelogram v0 + u (v1 - v0) + v (v3 - v0) may replace the quad: its fourth corner misses v2 by at
/// most widest_crack() and 1/1000 of the shorter side.
bool is_parallelogram(Vec3 v0, Vec3 v1, Vec3 v2, Vec3 v3, const SceneScale& scale);

/// True if four texture points form a parallelogram, with a gap of at most 1/1000 of the shorter side, so that one
/// TextureFrame fits them. Also true if none of the corners has a texture point.
bool is_parallelogram(const std::array<std::uint32_t, 4>& points, const ObjMesh& mesh);

/// The faces of a mesh, cut into triangles and parallelograms.
struct MeshPieces
{
    LargeVector<Piece> pieces;       ///< in the order of the faces
    std::size_t zero_area_faces = 0; ///< dropped
    std::vector<std::string> warnings;
};

/// Cuts the faces of a mesh. Parallelograms stay whole, textured ones only if their texture points form one, too. Other
/// convex quads are cut along the diagonal from their first to their third corner, all other polygons by ear clipping.
/// Corners on a straight side are skipped. Polygons that are not planar (off their mean plane by more than 1e-4 of
/// their size and widest_crack()) or intersect themselves cause a warning. Throws InputError for a concave polygon that
/// would take too long: one whose corners times reflex corners exceed 10^8.
MeshPieces cut_into_pieces(const ObjMesh& mesh, const SceneScale& scale);

} // namespace multipath
