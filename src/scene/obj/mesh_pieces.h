#pragma once

#include "geometry/vec3.h"
#include "scene/obj/obj_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// The area of a closed polygon times its unit normal (Newell's formula). Its corners run counter-clockwise seen from
/// the front.
Vec3 area_vector(const std::vector<Vec3>& corners);

/// The largest distance of a corner from the polygon's mean plane [scene units]; 0 for a planar polygon. The area
/// vector must not be zero.
double distance_from_plane(const std::vector<Vec3>& corners, Vec3 area_vector);

/// The number of reflex corners, which turn clockwise; 0 for a convex polygon.
std::size_t reflex_corner_count(const std::vector<Vec3>& corners, Vec3 area_vector);

/// Triangles given by indices of the polygon's corners, counter-clockwise like the polygon.
struct Triangulation
{
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool crosses_itself = false; ///< not a simple polygon: the triangles overlap
};

/// Triangulates a polygon whose area vector is not zero, by ear clipping. Seen along that vector, the triangles cover
/// the polygon once, unless it crosses itself. A corner counts as straight, and is dropped without a triangle, if the
/// triangle with its two neighbours has an area of at most `smallest_area` [scene units^2] when it is projected along
/// the axis of the largest component of the area vector. The time is proportional to corners x (1 + reflex corners).
Triangulation clip_ears(const std::vector<Vec3>& corners, Vec3 area_vector, double smallest_area);

/// Tolerances in proportion to the size of a scene, so that its unit does not matter.
struct SceneScale
{
    double extent = 0.0; ///< longest side of the box around all faces [scene units]

    /// Triangles up to this area [square scene units] count as degenerate: the square of 1e-7 extents, the resolution
    /// of single precision.
    double smallest_area() const { return 1e-14 * extent * extent; }
    bool is_degenerate(Vec3 a, Vec3 b, Vec3 c) const { return 0.5 * length(cross(b - a, c - a)) <= smallest_area(); }
    /// Surfaces may miss the corners of the file by this distance [scene units]. A wider gap would show as a crack.
    double widest_crack() const { return 2e-6 * extent; }
};

SceneScale scale_of(const ObjMesh& mesh);

/// A triangle or parallelogram of the mesh. Its corners run counter-clockwise seen from the front.
struct Piece
{
    static constexpr std::uint32_t no_colour = 0xffffffffu;

    std::array<ObjCorner, 4> corners; ///< the fourth is unused in a triangle
    std::uint32_t face = 0;           ///< index of the face that the piece is part of
    std::uint32_t colour = no_colour; ///< index into MeshPieces::colours

    bool is_triangle() const { return corners[3].vertex == ObjCorner::none; }
    std::size_t corner_count() const { return is_triangle() ? 3 : 4; }
    ObjCorner end_of_v() const { return corners[corner_count() - 1]; } ///< corners[0] and [1] are the ends of edge_u
    bool has_texture_points() const;                                   ///< of all corners
};

/// True if the parallelogram v0 + u (v1 - v0) + v (v3 - v0) may replace the quad v0, v1, v2, v3: the distance of its
/// corner v1 + v3 - v0 from v2 is at most widest_crack() and at most 1/1000 of the shorter side at v0.
bool is_parallelogram(Vec3 v0, Vec3 v1, Vec3 v2, Vec3 v3, const SceneScale& scale);

/// True if the texture points of four corners form a parallelogram, up to an error of 1/1000 of its shorter side, so
/// that one TextureFrame fits them, or if none of the corners has a texture point.
bool is_texture_parallelogram(const std::array<ObjCorner, 4>& corners, const ObjMesh& mesh);

/// The faces of a mesh, cut into triangles and parallelograms.
struct MeshPieces
{
    LargeVector<Piece> pieces; ///< in the order of the faces
    /// Different colours of pieces by their vertices, rounded to 8 bits per channel in sRGB.
    std::vector<std::array<std::uint8_t, 3>> colours;
    std::vector<std::string> warnings;
};

/// Cuts the faces of a mesh. Corners on a straight side are skipped. A parallelogram stays whole; a textured one is cut
/// unless its texture points form a parallelogram, too. Any other convex quad is cut along the diagonal from its first
/// to its third corner, any other polygon by ear clipping. A piece without a texture has the mean colour of those of
/// its vertices that have one. Faces without area are dropped with a warning. Polygons that are not planar (off their
/// mean plane by more than 1e-4 of the root of their area and more than widest_crack()) or intersect themselves are cut
/// with one. Throws InputError for a concave polygon that would take too long: the number of its corners times the
/// number of its reflex corners exceeds 10^8.
MeshPieces cut_into_pieces(const ObjMesh& mesh, const SceneScale& scale);

} // namespace multipath
