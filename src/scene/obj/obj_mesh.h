#pragma once

#include "geometry/vec3.h"
#include "parallel/memory.h"
#include "scene/texture/texture.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// A polygon of an OBJ file; its corners are the next `corner_count` entries of ObjMesh::corners.
struct ObjFace
{
    std::uint32_t corner_count = 0; ///< at least 3
    std::uint32_t line = 0;
    std::uint32_t material = 0; ///< index into ObjMesh::materials
    std::uint32_t group = 0;    ///< index into ObjMesh::groups
};

/// A name and the line of its first use.
struct ObjName
{
    std::string name;
    std::uint32_t line = 0;
};

/// The contents of an OBJ file, before its polygons are cut and its materials are looked up.
struct ObjMesh
{
    static constexpr std::uint32_t no_point = 0xffffffffu;

    std::string path;
    LargeVector<Vec3> vertices;
    LargeVector<std::uint32_t> corners; ///< vertex indices, all valid, face after face
    /// The index of the texture point of each corner, or no_point; empty if no corner has one.
    LargeVector<std::uint32_t> corner_points;
    LargeVector<TexturePoint> texture_points;
    LargeVector<ObjFace> faces;
    std::vector<ObjName> materials;        ///< names in `usemtl` that faces use; "" before the first `usemtl`
    std::vector<std::string> groups;       ///< names in `o` and `g` that faces use, in order of appearance
    std::vector<ObjName> libraries;        ///< arguments of `mtllib`, not yet split into names
    std::size_t faces_without_corners = 0; ///< dropped: fewer than three vertices
    std::vector<std::string> warnings;
    std::vector<bool> textured = {}; ///< per material: true if it has a texture; empty before MTL files are read

    bool is_textured(const ObjFace& face) const { return !textured.empty() && textured[face.material]; }
};

/// Parses an OBJ file. Throws InputError for any error in its text, and for a file without faces.
ObjMesh parse_obj(const std::string& path);

} // namespace multipath
