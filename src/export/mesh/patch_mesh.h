#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// True for each patch that is invisible in all pictures because coplanar surfaces cover all of it, up to slivers. As
/// in Intersector::closest_hit, a front lies over a back; of two coincident surfaces that face the same way, the
/// smaller lies on top, and the larger seen from behind. A mesh with the covered patches would flicker (z-fighting).
std::vector<bool> covered_patches(const Scene& scene, int threads);

/// The point [scene units] that the positions of meshes are relative to, since floats have only seven digits: (0, 0, 0)
/// unless the scene is more than four times its size away from there, else a point near its centre, exact in floats.
Vec3 mesh_origin(const Scene& scene);

/// The texture frame of a surface for numbers of single precision: far from (0, 0), a repeated image is moved by whole
/// images, which shows the same.
TextureFrame mesh_texture_frame(const Scene& scene, std::uint32_t surface);

using Float3 = std::array<float, 3>;

inline Float3 single(Vec3 v)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
inline Float3 single(Rgb c)
{
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}
inline Vec3 to_vec3(Float3 p)
{
    return {p[0], p[1], p[2]};
}
inline Rgb to_rgb(Float3 c)
{
    return {c[0], c[1], c[2]};
}

/// A triangle or quadrilateral, counter-clockwise as seen from the side of the surface, front or back, that its patch
/// is on.
struct MeshFace
{
    std::array<std::uint32_t, 4> corners{}; ///< indices of vertices
    std::uint32_t corner_count = 4;         ///< 3 or 4
    std::uint32_t patch = 0;

    const std::uint32_t* begin() const { return corners.data(); }
    const std::uint32_t* end() const { return corners.data() + corner_count; }
};

/// The front or back of a surface, and its range of vertices and faces in the mesh.
struct MeshSide
{
    std::uint32_t surface = 0;
    bool front = true;
    Vec3 normal; ///< unit normal of the side
    std::size_t first_vertex = 0;
    std::size_t vertex_count = 0;
    std::size_t first_face = 0;
    std::size_t face_count = 0;
};

/// The patches as vertices and faces, in single precision like mesh files. The ranges of the sides follow each other
/// without gaps.
struct PatchMesh
{
    Vec3 origin;                   ///< [scene units] see mesh_origin()
    std::vector<Float3> positions; ///< [scene units] per vertex, relative to the origin
    std::vector<Float3> radiosity; ///< [W/m^2] per vertex
    std::vector<Float3> error;     ///< [W/m^2] standard error of the radiosity per vertex; empty if unknown
    std::vector<MeshFace> faces;
    std::vector<MeshSide> sides;
};

/// [W/m^2] Values at the corners of a patch, in the order of Scene::corners(). For a triangle the fourth is ignored.
using CornerFunction = std::function<std::array<Rgb, 4>(std::uint32_t patch)>;

/// Colour on the screen for a radiosity [W/m^2]: encoded sRGB in [0, 1].
using ScreenColour = std::function<Rgb(Rgb radiosity)>;

/// Flat shading: the value of a patch at all its corners. The values must outlive the result.
CornerFunction flat_corners(const std::vector<Rgb>& values_per_patch);

/// Builds the mesh of the fronts of all surfaces but the sky and, if the scene is two-sided, of their backs: surface by
/// surface, front before back. Patches that coplanar surfaces hide (covered_patches()) are left out. A vertex is shared
/// only by patches of one side whose radiosity and error there are equal in single precision. There are no T-junctions,
/// which would show as cracks: a patch with corners of other patches between the ends of an edge is split into a fan of
/// triangles around its centre. `error` may be an empty function; then PatchMesh::error is empty. Throws InputError for
/// 2^31 vertices or more.
PatchMesh patch_mesh(const Scene& scene, const CornerFunction& radiosity, const CornerFunction& error, int threads = 1);

} // namespace multipath
