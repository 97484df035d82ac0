#pragma once

#include "base/memory.h"
#include "geometry/vec3.h"
#include "scene/rgb.h"
#include "scene/texture/texture.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// A corner of a face: `v`, or `v/vt`.
struct ObjCorner
{
    static constexpr std::uint32_t none = 0xffffffffu;

    std::uint32_t vertex = none; ///< index into ObjMesh::vertices
    std::uint32_t point = none;  ///< index into ObjMesh::texture_points; none if the corner has no texture point
};

/// A polygon of an OBJ file.
struct ObjFace
{
    std::uint32_t first_corner = 0; ///< index into ObjMesh::corners; the other corners follow
    std::uint32_t corner_count = 0; ///< at least 3
    std::uint32_t line = 0;         ///< line of the face in the file
    std::uint32_t material = 0;     ///< index into ObjMesh::materials
    std::uint32_t group = 0;        ///< index into ObjMesh::groups
};

/// A name of a material and the line of the first face that uses it, or the argument of a `mtllib` statement and its
/// line.
struct ObjName
{
    std::string name;
    std::uint32_t line = 0;
};

/// The names in `o` and `g` that apply to a face.
struct ObjGroup
{
    std::string name;  ///< the last one; "" before the first
    std::string other; ///< the object that a `g` divides; or ""
};

/// The contents of an OBJ file, before its polygons are cut and its materials are looked up.
struct ObjMesh
{
    std::string path;
    LargeVector<Vec3> vertices;
    /// [1] Linear light of the colour of each vertex; negative if it has none. Empty if no vertex has another than
    /// white.
    LargeVector<Rgb> colours;
    LargeVector<ObjCorner> corners; ///< of all faces; all indices are valid
    LargeVector<TexturePoint> texture_points;
    LargeVector<ObjFace> faces;
    /// Arguments of `usemtl` that apply to a face, dropped or not, in order of appearance; "" before the first. A
    /// comment at their end is left until the names of the MTL files are known.
    std::vector<ObjName> materials;
    std::vector<ObjGroup> groups;   ///< those of faces, dropped or not, in order of appearance
    std::vector<ObjName> libraries; ///< different arguments of `mtllib`, not yet split into file names
    std::vector<std::string> warnings;
    /// Per material: true if the file of its `map_Kd` was found; empty before MTL files are read.
    std::vector<bool> textured = {};

    /// The names of the materials in options and results: "default" for "".
    std::vector<std::string> material_names() const;
    Vec3 at(ObjCorner corner) const { return vertices[corner.vertex]; }
    bool is_textured(const ObjFace& face) const { return !textured.empty() && textured[face.material]; }
};

/// Parses an OBJ file. Throws InputError for a file that cannot be read, malformed vertices and faces, coordinates
/// beyond 1e9, free-form surfaces and included files, a file without faces, 2^31 or more vertices or corners, and
/// more than 256 different `mtllib` statements. These cause a warning: unknown statements; faces with fewer than three
/// vertices, which are dropped; weights of vertices other than 1, and colours that are not red, green and blue from 0
/// to 1; a texture coordinate that is malformed or beyond 1e9, which counts as 0; and a reference to a missing texture
/// point, which is ignored.
ObjMesh parse_obj(const std::string& path);

} // namespace multipath
