#pragma once

#include "scene/obj/obj_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// What is too small to matter in a scene; everything follows from the size of the scene, so its unit does not matter.
struct SceneScale
{
    double extent = 0.0; ///< longest side of the box around all faces [scene units]

    /// A triangle with a side of 1e-7 of the scene, the resolution of single precision: below it is no area.
    double smallest_area() const { return 1e-14 * extent * extent; }
    /// Surfaces may miss the corners of the file by this much before the gap shows as a crack.
    double widest_crack() const { return 2e-6 * extent; }
};

SceneScale scale_of(const ObjMesh& mesh);

/// A triangle or a parallelogram of the mesh, by vertex numbers, counter-clockwise.
struct Piece
{
    static constexpr std::uint32_t no_vertex = 0xffffffffu;

    std::array<std::uint32_t, 4> corners; ///< the last is no_vertex in a triangle
    std::uint32_t face = 0;
    std::array<std::uint32_t, 4> points = {}; ///< texture points of the corners, where the mesh has any

    bool is_triangle() const { return corners[3] == no_vertex; }
};

/// Whether the surface v0 + u (v1 - v0) + v (v3 - v0) meets v2 closely enough to stand for the quad: the gap is at most
/// widest_crack() and 1/1000 of the shorter side.
bool is_parallelogram(Vec3 v0, Vec3 v1, Vec3 v2, Vec3 v3, const SceneScale& scale);

/// Whether four texture points lie like the corners of a parallelogram, so that one frame holds for all: their gap is
/// at most a thousandth of a side. True if none has a point.
bool is_parallelogram(const std::array<std::uint32_t, 4>& points, const ObjMesh& mesh);

/// The faces of a mesh, cut.
struct MeshPieces
{
    LargeVector<Piece> pieces;       ///< in the order of the faces
    std::size_t zero_area_faces = 0; ///< dropped
    std::vector<std::string> warnings;
};

/// Parallelograms stay whole, textured ones if their texture points are one, too; other convex quads are cut along the
/// diagonal from their first to their third corner, all other polygons by ear clipping. Corners on a straight side are
/// passed over. Polygons that are not planar (off their mean plane by more than 1e-4 of their size and widest_crack())
/// and polygons that cross themselves get a warning. Throws InputError for a concave polygon of far more than 10,000
/// corners.
MeshPieces cut_into_pieces(const ObjMesh& mesh, const SceneScale& scale);

} // namespace multipath
