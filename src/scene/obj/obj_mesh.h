#pragma once

#include "base/memory.h"
#include "geometry/vec3.h"
#include "scene/rgb.h"
#include "scene/texture/texture.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// A polygon of an OBJ file. The corners of all faces are stored in ObjMesh::corners, face after face.
struct ObjFace
{
    std::uint32_t corner_count = 0; ///< number of corners of this face, at least 3
    std::uint32_t line = 0;         ///< line of the face in the file
    std::uint32_t material = 0;     ///< index into ObjMesh::materials
    std::uint32_t group = 0;        ///< index into ObjMesh::groups
    std::uint32_t other_name = 0;   ///< index into ObjMesh::other_names
};

/// Counts the lines with the same flaw, for a single warning.
struct FlawCount
{
    std::uint32_t first_line = 0;
    std::size_t count = 0;

    void add(std::uint32_t line)
    {
        first_line = count == 0 ? line : first_line;
        ++count;
    }
};

/// A name of a material and the line of the first face that uses it, or the argument of a `mtllib` statement and its
/// line.
struct ObjName
{
    std::string name;
    std::uint32_t line = 0;
};

/// The name of a material in options and results.
inline std::string name_of_material(const ObjName& material)
{
    return material.name.empty() ? "default" : material.name;
}

/// The contents of an OBJ file, before its polygons are cut and its materials are looked up.
struct ObjMesh
{
    static constexpr std::uint32_t no_point = 0xffffffffu;

    std::string path;
    LargeVector<Vec3> vertices;
    /// [1] Linear light of the colour of each vertex; negative if it has none. Empty if no vertex has another than
    /// white.
    LargeVector<Rgb> colours;
    LargeVector<std::uint32_t> corners; ///< vertex indices, all valid, face after face
    /// The index of the texture point of each corner, or no_point. Empty if no corner refers to one.
    LargeVector<std::uint32_t> corner_points;
    LargeVector<TexturePoint> texture_points;
    LargeVector<ObjFace> faces;
    /// Arguments of `usemtl` that apply to a face, dropped or not, in order of appearance; "" before the first. A
    /// comment at their end is left until the names of the MTL files are known.
    std::vector<ObjName> materials;
    /// Names in `o` and `g` that apply to a face, dropped or not, in order of appearance; "" before the first. Each
    /// face has the last one.
    std::vector<std::string> groups;
    /// The names of objects that a `g` divides, and of groups directly before an `o`; the first is "".
    std::vector<std::string> other_names = {""};
    std::vector<ObjName> libraries;        ///< different arguments of `mtllib`, not yet split into file names
    std::size_t faces_without_corners = 0; ///< number of faces with fewer than three vertices, which were dropped
    std::vector<std::string> warnings;
    /// Per material: true if the file of its `map_Kd` was found; empty before MTL files are read.
    std::vector<bool> textured = {};

    bool is_textured(const ObjFace& face) const { return !textured.empty() && textured[face.material]; }
};

/// Parses an OBJ file. Throws InputError for a file that cannot be read, malformed vertices and faces, coordinates
/// beyond 1e9, free-form surfaces and included files, a file without faces, 2^31 or more vertices or corners, and
/// more than 256 different `mtllib` statements. These cause a warning: unknown statements; weights of vertices other
/// than 1, and colours that are not red, green and blue from 0 to 1; a texture coordinate that is malformed or beyond
/// 1e9, which counts as 0; and a reference to a missing texture point, which is ignored.
ObjMesh parse_obj(const std::string& path);

} // namespace multipath
